// SPDX-License-Identifier: Apache-2.0
// What a calibration from motion expects the sums of readings (MotionEvidence) and the distances to be, with
// analytic derivatives. Gyroscope: the turn of the board between two nodes. Accelerometer: second difference
// of its place at three nodes, plus gravity. Distance: source at emission, microphone at arrival, on a
// parabola through three nodes. How far tissue has moved with the joints is taken from the trajectory before
// (freezeFlesh), without derivatives of its own.
#pragma once

#include <array>

#include "core/calibration/motion/motion_evidence.h"
#include "core/calibration/motion/motion_unknowns.h"

namespace noctule {

class MotionModel {
public:
    /// Keeps a reference to the body. Every board and source must be on the body.
    MotionModel(const MotionBody& body, const Observations& take, const MotionLayout& layout, double step_s);

    int boardSegment(int board) const { return boards_[static_cast<size_t>(board)].segment; }
    int sourceSegment(int source) const { return sources_[static_cast<size_t>(source)].segment; }

    /// To be called after every change of the nodes; `rest_of_node` is the node in the rest pose that each
    /// node's tissue is compared with.
    void freezeFlesh(const MotionUnknowns& unknowns, const std::vector<int>& rest_of_node);
    const Vector6& features(int node, int board) const {
        return features_[static_cast<size_t>(node)][static_cast<size_t>(board)];
    }

    /// `since_middle_s`: of the time on which the gyroscope's drift counts.
    ResidualBlock gyro(const MotionUnknowns& unknowns, int board, int node, const BoardTurn& turn,
                       double since_middle_s) const;
    ResidualBlock accel(const MotionUnknowns& unknowns, int board, int node, const BoardForce& force) const;
    /// `distance.node` counts from `first_node`.
    ResidualBlock distance(const MotionUnknowns& unknowns, const HeardDistance& distance,
                           int first_node) const;
    Matrix3d boardOrientation(const MotionUnknowns& unknowns, int board, int node) const;

private:
    struct Part {
        int segment = 0;
        std::vector<ChainBone> chain{};
        Vector3d p_board_mic_m = Vector3d::Zero();
    };
    /// A segment's orientation between nodes, and its turn by those of the node before, the node, the node
    /// after.
    struct Between {
        Matrix3d R;
        std::array<Matrix3d, 3> by;
    };
    struct PartAt;

    const BoardConstants& constants(const MotionUnknowns& unknowns, int board) const {
        return unknowns.boards[static_cast<size_t>(board)];
    }
    Matrix3d fleshTilt(const MotionUnknowns& unknowns, int board, int node) const;
    Vector3d placeOnSegment(const MotionUnknowns& unknowns, int board, int node) const;
    void addGyroEnd(const MotionUnknowns& unknowns, int board, int node, int slot, const Matrix3d& by_turn,
                    ResidualBlock& block) const;
    void addAccelTurns(const MotionUnknowns& unknowns, int board, int node, const Vector3d& a_world,
                       ResidualBlock& block) const;
    void addAccelPlaces(const MotionUnknowns& unknowns, int board, int node, const Matrix3d& R_board_world,
                        ResidualBlock& block) const;
    Vector3d place(const MotionUnknowns& unknowns, int board, int node) const;
    static Between between(const MotionUnknowns& unknowns, int node, int segment, double at);
    PartAt partAt(const MotionUnknowns& unknowns, const Part& part, const Vector3d& p_segment_m, int node,
                  double at) const;
    void addPart(const PartAt& at, const Part& part, const Vector3d& direction, ResidualBlock& block) const;

    const MotionBody& body_;
    MotionLayout layout_;
    double step_s_, g_m_per_s2_;
    std::vector<Part> boards_, sources_;
    std::vector<std::vector<Vector6>> features_;  ///< per node and board
};

}  // namespace noctule
