// SPDX-License-Identifier: Apache-2.0
// Boards and sources that hang in the room: anchors. They do not move and feel gravity alone.
#pragma once

#include "core/simulation/suit_world.h"
#include "core/simulation/worn_suit.h"

namespace noctule::simulation {

class AnchorWorld : public SuitWorld {
public:
    AnchorWorld(WornSuit anchors, double duration_s)
        : anchors_(std::move(anchors)), duration_s_(duration_s) {}

    double duration_s() const override { return duration_s_; }
    int boardCount() const override { return static_cast<int>(anchors_.boards.size()); }
    int sourceCount() const override { return static_cast<int>(anchors_.sources.size()); }
    Vector3d microphone(int board, double) const override {
        const WornBoard& worn = anchors_.boards[board];
        return worn.p_segment_board_m + worn.q_segment_board * worn.p_board_mic_m;
    }
    Vector3d source(int source, double) const override { return anchors_.sources[source].p_segment_source_m; }
    Vector3d sourceNormal(int source, double) const override {
        return anchors_.sources[source].normal_segment;
    }
    int boardSegment(int) const override { return -1; }
    int sourceSegment(int) const override { return -1; }
    int sourceBoard(int source) const override { return anchors_.sources[source].board; }
    void capsules(double, std::vector<WorldCapsule>& capsules) const override { capsules.clear(); }
    BoardMotion boardMotion(int board, double) const override {
        BoardMotion motion;
        motion.q_world_board = anchors_.boards[board].q_segment_board;
        motion.p_world_board_m = anchors_.boards[board].p_segment_board_m;
        motion.accel_m_per_s2 = motion.q_world_board.conjugate() * Vector3d(0, kStandardGravity_m_per_s2, 0);
        return motion;
    }
    void beginAgain() override {}

    const WornSuit& anchors() const { return anchors_; }

private:
    WornSuit anchors_;
    double duration_s_;
};

}  // namespace noctule::simulation
