// SPDX-License-Identifier: Apache-2.0
// A take as a calibration from motion reads it: instants ("nodes") at equal steps, and between them what each
// board felt, summed up so that nothing of it is lost and nothing of the motion needs to be smooth
// (preintegration; Forster, Carlone, Dellaert, Scaramuzza 2017, "On-Manifold Preintegration", without its
// biases): the turn from node to node, and the mean force under a triangle over the two steps about a node,
// which is exactly the second difference of the board's place. The sums are low-passes of one step, which
// soft tissue's wobble hardly passes.
#pragma once

#include <vector>

#include "core/calibration/observations.h"

namespace noctule {

/// From a node to the next one.
struct BoardTurn {
    bool heard = false;  ///< without gaps and within the range
    Quaterniond q_begin_end = Quaterniond::Identity();
};

/// About a node.
struct BoardForce {
    bool heard = false;
    Vector3d mean_m_per_s2 = Vector3d::Zero();  ///< specific force in the board's frame at the node
};

struct HeardDistance {
    int node = 0;
    double emitted = 0, arrived = 0;  ///< steps after the node, -0.5 .. about 0.6
    int source = 0, board = 0;
    double distance_m = 0, confidence = 1;
};

struct NodeSpan {
    int first = 0, count = 0;

    int middle() const { return first + count / 2; }
    /// Both this node and the next one.
    bool holdsStep(int node) const { return node >= first && node + 1 < first + count; }
};

struct MotionEvidence {
    double begin_s = 0, step_s = 0.1;
    int nodes = 0;
    std::vector<NodeSpan> rests{};  ///< the performer holds the rest pose; the first one begins with node 0
    std::vector<std::vector<BoardTurn>> turns{};    ///< per board, nodes - 1
    std::vector<std::vector<BoardForce>> forces{};  ///< per board, nodes; ends are not heard
    std::vector<HeardDistance> distances{};         ///< in order of nodes
    std::vector<double> heard_share{};              ///< per board, of its turns

    int restNodes() const;
    bool isStillStep(int node) const;  ///< from the node to the next one

    static constexpr double kLeastHeardShare = 0.5;
    bool isHeard(size_t board) const { return heard_share[board] >= kLeastHeardShare; }
};

struct StillStretch;

/// From shortly before the end of the rest pose on, for at most `longest_s`, with every return to it.
/// Gyroscopes' zeros are those of the first rest pose.
MotionEvidence readMotion(const Observations& take, const StillStretch& still, double step_s,
                          double longest_s);

}  // namespace noctule
