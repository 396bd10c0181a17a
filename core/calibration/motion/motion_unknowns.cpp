// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_unknowns.h"

#include "core/math/rotation.h"

namespace noctule {
namespace {

void moveBoard(BoardConstants& board, const MotionLayout& layout, int index, const Eigen::VectorXd& step) {
    const auto at = [&](int first) { return Vector3d(step.segment<3>(first)); };
    board.q_segment_board = (board.q_segment_board * expQuaternion(at(layout.mounting(index)))).normalized();
    board.p_segment_board_m += at(layout.place(index));
    board.gyro_zero_rad_per_s += at(layout.gyroZero(index));
    board.gyro_drift_rad_per_s2 += at(layout.gyroDrift(index));
    board.accel_zero_m_per_s2 += at(layout.accelZero(index));
    for (int f = 0; layout.flesh && f < 6; ++f) {
        board.tilt_rad.col(f) += at(layout.tilt(index, f));
        board.shift_m.col(f) += at(layout.shift(index, f));
    }
}

}  // namespace

Vector6 jointFeatures(const MotionBody& body, const MotionNode& node, int segment) {
    Vector6 features = Vector6::Zero();
    const auto turn = [&](int lower) -> Vector3d {
        const Matrix3d& R_world_lower = node.R_world_segment[static_cast<size_t>(lower)];
        const int upper = body.segment(lower).parent;
        return halfSines(node.R_world_segment[static_cast<size_t>(upper)].transpose() * R_world_lower);
    };
    if (body.segment(segment).parent >= 0)
        features.head<3>() = turn(segment);
    if (body.segment(segment).first_child >= 0)
        features.tail<3>() = turn(body.segment(segment).first_child);
    return features;
}

void move(MotionUnknowns& unknowns, const MotionLayout& layout, const Eigen::MatrixXd& node_steps,
          const Eigen::VectorXd& border) {
    for (size_t k = 0; k < unknowns.nodes.size(); ++k) {
        const Eigen::VectorXd step = node_steps.col(static_cast<Eigen::Index>(k));
        MotionNode& node = unknowns.nodes[k];
        node.p_world_root_m += step.head<3>();
        for (int s = 0; s < layout.segments; ++s) {
            Matrix3d& R = node.R_world_segment[static_cast<size_t>(s)];
            const Vector3d turn = step.segment<3>(MotionLayout::segment(s));
            R = (Quaterniond(R) * expQuaternion(turn)).normalized().toRotationMatrix();
        }
    }
    for (int b = 0; b < layout.boards; ++b)
        moveBoard(unknowns.boards[static_cast<size_t>(b)], layout, b, border);
    for (int s = 0; s < layout.sources; ++s) {
        unknowns.sources[static_cast<size_t>(s)].p_segment_source_m += border.segment<3>(layout.source(s));
        unknowns.sources[static_cast<size_t>(s)].offset_m += border[layout.offset(s)];
    }
    for (int bone = 0; bone < layout.bones; ++bone)
        unknowns.bone_scale[static_cast<size_t>(bone)] += border[layout.bone(bone)];
    unknowns.sound_scale += border[layout.soundScale()];
}

}  // namespace noctule
