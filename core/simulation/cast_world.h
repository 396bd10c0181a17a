// SPDX-License-Identifier: Apache-2.0
// Several suits in one world. CastWorld is that world as one suit's pulses meet it: the sources are that
// suit's, the boards those of all suits in their order or of one, and every body stands in the way.
// ClockedWorld is a world as a box sees it whose clock differs: times are that box's.
#pragma once

#include <optional>

#include "core/simulation/box_clock.h"
#include "core/simulation/suit_world.h"

namespace noctule::simulation {

/// A board of one of several suits; both count from 0.
struct BoardOfCast {
    size_t suit = 0;
    int board = 0;
};

class CastWorld : public World {
public:
    /// The suits must outlive the object. `speaker`: whose sources these are; `listener`: whose boards, none:
    /// all.
    CastWorld(std::vector<const World*> suits, size_t speaker, std::optional<size_t> listener = {});

    BoardOfCast ownerOf(int board) const { return boards_[board]; }

    double duration_s() const override { return suits_[speaker_]->duration_s(); }
    int boardCount() const override { return static_cast<int>(boards_.size()); }
    int sourceCount() const override { return suits_[speaker_]->sourceCount(); }
    Vector3d microphone(int board, double t_s) const override;
    Vector3d source(int source, double t_s) const override { return suits_[speaker_]->source(source, t_s); }
    Vector3d sourceNormal(int source, double t_s) const override {
        return suits_[speaker_]->sourceNormal(source, t_s);
    }
    /// Segments of different bodies differ, here and in capsules().
    int boardSegment(int board) const override;
    int sourceSegment(int source) const override;
    int sourceBoard(int source) const override;
    void capsules(double t_s, std::vector<WorldCapsule>& capsules) const override;

private:
    std::vector<const World*> suits_;
    size_t speaker_;
    std::vector<BoardOfCast> boards_;
    mutable std::vector<WorldCapsule> of_one_;
};

class ClockedWorld : public SuitWorld {
public:
    /// Both must outlive the object.
    ClockedWorld(SuitWorld& world, const BoxClock& clock) : world_(world), clock_(clock) {}

    double duration_s() const override { return clock_.suitTime_s(world_.duration_s()); }
    int boardCount() const override { return world_.boardCount(); }
    int sourceCount() const override { return world_.sourceCount(); }
    Vector3d microphone(int board, double t_s) const override {
        return world_.microphone(board, takeTime_s(t_s));
    }
    Vector3d source(int source, double t_s) const override { return world_.source(source, takeTime_s(t_s)); }
    Vector3d sourceNormal(int source, double t_s) const override {
        return world_.sourceNormal(source, takeTime_s(t_s));
    }
    int boardSegment(int board) const override { return world_.boardSegment(board); }
    int sourceSegment(int source) const override { return world_.sourceSegment(source); }
    int sourceBoard(int source) const override { return world_.sourceBoard(source); }
    void capsules(double t_s, std::vector<WorldCapsule>& capsules) const override {
        world_.capsules(takeTime_s(t_s), capsules);
    }
    BoardMotion boardMotion(int board, double t_s) const override {
        return world_.boardMotion(board, takeTime_s(t_s));
    }
    void beginAgain() override { world_.beginAgain(); }

private:
    double takeTime_s(double suit_s) const { return clock_.takeTime_s(suit_s); }

    SuitWorld& world_;
    const BoxClock& clock_;
};

}  // namespace noctule::simulation
