// SPDX-License-Identifier: Apache-2.0
// What a calibration from motion knows besides the readings: the rest pose, what joints cannot do, the suit's
// and the actor's measures, and weak ties that keep what nothing shows where it was.
#pragma once

#include <functional>

#include "core/calibration/motion/motion_settings.h"
#include "core/calibration/motion/motion_unknowns.h"

namespace noctule {

/// Takes a weighted block.
using ResidualSink = std::function<void(const ResidualBlock&)>;

/// Where the constants are thought to be.
struct ExpectedConstants {
    std::vector<BoardConstants> boards{};
    std::vector<SourceConstants> sources{};
    std::vector<bool> held_fast{};             ///< per board: it stays where it is expected; empty: none does
    static constexpr double kHeldFast = 1e-3;  ///< of a prior's sigma

    double shareOfSigma(size_t board) const {
        return board < held_fast.size() && held_fast[board] ? kHeldFast : 1;
    }
};

class MotionPriors {
public:
    MotionPriors(const MotionBody& body, const MotionLayout& layout, const MotionSettings& settings)
        : body_(body), layout_(layout), settings_(settings) {}

    void addConstants(const MotionUnknowns& unknowns, const ExpectedConstants& expected,
                      const std::vector<int>& board_segments, const ResidualSink& sink) const;
    /// At one node, in the middle of the stillness. In a take's `first` rest pose one stands in the world's
    /// middle and looks along its z; in later ones anywhere.
    void addRest(const MotionUnknowns& unknowns, int node, bool first, const ResidualSink& sink) const;
    /// What the joints of one node cannot do.
    void addJoints(const MotionUnknowns& unknowns, int node, const ResidualSink& sink) const;
    /// From a node to the next one: the root goes no faster than people do, and not at all while it is
    /// `still`.
    void addRootStep(const MotionUnknowns& unknowns, int node, bool still, const ResidualSink& sink) const;
    /// A segment of whose turn nothing is heard follows its parent.
    void addFollowing(const MotionUnknowns& unknowns, int node, int segment, const ResidualSink& sink) const;

private:
    void addLevel(const Matrix3d& R_world_segment, int node, int segment, const ResidualSink& sink) const;
    void addBoard(const BoardConstants& board, const ExpectedConstants& all_expected, int index,
                  const Vector3d& along, const ResidualSink& sink) const;

    const MotionBody& body_;
    MotionLayout layout_;
    const MotionSettings& settings_;
};

}  // namespace noctule
