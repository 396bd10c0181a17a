// SPDX-License-Identifier: Apache-2.0
// What a calibration from motion solves for, and where it stands among the columns: per node of time the
// root's place and every segment's orientation; constants of boards, sources, bones and the air. Rotations
// are perturbed on the right. SI units.
#pragma once

#include <vector>

#include "core/calibration/motion/arrowhead_system.h"
#include "core/calibration/motion/motion_body.h"
#include "core/suit/board_flesh.h"

namespace noctule {

struct MotionNode {
    Vector3d p_world_root_m = Vector3d::Zero();
    std::vector<Matrix3d> R_world_segment{};
};

/// A board on its flesh (BoardFlesh).
struct BoardConstants {
    Quaterniond q_segment_board = Quaterniond::Identity();
    Vector3d p_segment_board_m = Vector3d::Zero();
    Vector3d gyro_zero_rad_per_s = Vector3d::Zero(), gyro_drift_rad_per_s2 = Vector3d::Zero();
    Vector3d accel_zero_m_per_s2 = Vector3d::Zero();
    Matrix36 tilt_rad = Matrix36::Zero(), shift_m = Matrix36::Zero();  ///< per unit of a feature
};

struct SourceConstants {
    Vector3d p_segment_source_m = Vector3d::Zero();
    double offset_m = 0;  ///< constant error of its distances
};

struct MotionUnknowns {
    std::vector<MotionNode> nodes{};
    std::vector<BoardConstants> boards{};
    std::vector<SourceConstants> sources{};
    std::vector<double> bone_scale{};  ///< per bone; 1: as the actor's measures say
    double sound_scale = 1;
};

/// First columns.
struct MotionLayout {
    int segments = 0, boards = 0, sources = 0, bones = 0;
    bool flesh = true;  ///< tilt and shift are solved for

    static constexpr int kPlain =
        15;  ///< of a board: turn, shift, gyroscope's zero and drift, accelerometer's zero
    int nodeSize() const { return 3 + 3 * segments; }
    static int segment(int index) { return 3 + 3 * index; }
    int boardSize() const { return flesh ? kPlain + 36 : kPlain; }
    int mounting(int board) const { return board * boardSize(); }
    int place(int board) const { return mounting(board) + 3; }
    int gyroZero(int board) const { return mounting(board) + 6; }
    int gyroDrift(int board) const { return mounting(board) + 9; }
    int accelZero(int board) const { return mounting(board) + 12; }
    int tilt(int board, int feature) const { return mounting(board) + kPlain + 3 * feature; }
    int shift(int board, int feature) const { return tilt(board, 6 + feature); }
    int source(int index) const { return boards * boardSize() + 4 * index; }
    int offset(int index) const { return source(index) + 3; }
    int bone(int index) const { return source(sources) + index; }
    int soundScale() const { return bone(bones); }
    int borderSize() const { return soundScale() + 1; }
};

/// Half the sines of the turns about x, y, z of the segment's own joint and of the next one, which are smooth
/// for every turn.
Vector6 jointFeatures(const MotionBody& body, const MotionNode& node, int segment);

/// Adds steps: a column per node, and the border's.
void move(MotionUnknowns& unknowns, const MotionLayout& layout, const Eigen::MatrixXd& node_steps,
          const Eigen::VectorXd& border_step);

}  // namespace noctule
