// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_priors.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kYawSigma_rad = 1e-3, kRootPlaceSigma_m = 1;  // nothing shows where and which way one stands
constexpr double kRootStillSpeed_m_per_s = 0.02, kRootSpeed_m_per_s = 2;
constexpr double kUnheardTurn_rad = 0.3;

double informationOf(double sigma) {
    return 1 / (sigma * sigma);
}

ResidualBlock blockOf(int node, const Vector3d& residual, double sigma) {
    ResidualBlock block;
    block.first_node = node;
    block.residual = residual;
    block.weight.setConstant(informationOf(sigma));
    return block;
}

Vector3d turnOf(const Matrix3d& R) {
    return logQuaternion(Quaterniond(R));
}

/// Two unit vectors across a unit vector.
Eigen::Matrix<double, 2, 3> across(const Vector3d& axis) {
    Eigen::Matrix<double, 2, 3> rows;
    rows.row(0) = axis.unitOrthogonal();
    rows.row(1) = axis.cross(Vector3d(axis.unitOrthogonal()));
    return rows;
}

}  // namespace

void MotionPriors::addBoard(const BoardConstants& board, const ExpectedConstants& all_expected, int index,
                            const Vector3d& along, const ResidualSink& sink) const {
    const auto add = [&](int first, const Vector3d& residual, double sigma, const Matrix3d& J) {
        ResidualBlock block = blockOf(0, residual, sigma);
        block.addBorder(first, J);
        sink(block);
    };
    const auto b = static_cast<size_t>(index);
    const BoardConstants& expected = all_expected.boards[b];
    const double share = all_expected.shareOfSigma(b);
    const Matrix3d I = Matrix3d::Identity();
    const Vector3d turn = logQuaternion(expected.q_segment_board.conjugate() * board.q_segment_board);
    add(layout_.mounting(index), turn, share * settings_.sigma_mounting_rad, rightJacobian(turn).inverse());
    add(layout_.place(index), board.p_segment_board_m - expected.p_segment_board_m,
        share * settings_.sigma_place_m, I);
    add(layout_.gyroZero(index), board.gyro_zero_rad_per_s, settings_.sigma_gyro_zero_rad_per_s, I);
    add(layout_.gyroDrift(index), board.gyro_drift_rad_per_s2, settings_.sigma_gyro_drift_rad_per_s2, I);
    add(layout_.accelZero(index), board.accel_zero_m_per_s2, settings_.sigma_accel_zero_m_per_s2, I);
    const double sigma_tilt_rad = share * settings_.sigma_tilt_rad;
    for (int f = 0; layout_.flesh && f < 6; ++f) {
        // A lag behind the axial turn tilts about the bone with the own joint's turn about it: 2 features a
        // turn.
        ResidualBlock tilt = blockOf(0, board.tilt_rad.col(f) - expected.tilt_rad.col(f), sigma_tilt_rad);
        if (f < 3)
            for (int axis = 0; axis < 3; ++axis)
                tilt.weight[axis] = informationOf(std::hypot(
                    sigma_tilt_rad, 2 * share * settings_.sigma_twist_lag * along[axis] * along[f]));
        tilt.addBorder(layout_.tilt(index, f), I);
        sink(tilt);
        add(layout_.shift(index, f), board.shift_m.col(f) - expected.shift_m.col(f),
            share * settings_.sigma_shift_m, I);
    }
}

void MotionPriors::addConstants(const MotionUnknowns& unknowns, const ExpectedConstants& expected,
                                const std::vector<int>& board_segments, const ResidualSink& sink) const {
    for (size_t b = 0; b < unknowns.boards.size(); ++b)
        addBoard(unknowns.boards[b], expected, static_cast<int>(b), body_.segment(board_segments[b]).along,
                 sink);
    const auto addScalar = [&](int column, double residual, double sigma) {
        ResidualBlock block = blockOf(0, {residual, 0, 0}, sigma);
        block.rows = 1;
        block.addBorder(column, Vector3d(Vector3d::UnitX()));
        sink(block);
    };
    for (size_t s = 0; s < unknowns.sources.size(); ++s) {
        const SourceConstants &source = unknowns.sources[s], &from = expected.sources[s];
        ResidualBlock block =
            blockOf(0, source.p_segment_source_m - from.p_segment_source_m, settings_.sigma_source_m);
        block.addBorder(layout_.source(static_cast<int>(s)), Matrix3d(Matrix3d::Identity()));
        sink(block);
        addScalar(layout_.offset(static_cast<int>(s)), source.offset_m - from.offset_m,
                  settings_.sigma_offset_m);
    }
    for (size_t bone = 0; bone < unknowns.bone_scale.size(); ++bone)
        addScalar(layout_.bone(static_cast<int>(bone)), unknowns.bone_scale[bone] - 1, settings_.sigma_bone);
    addScalar(layout_.soundScale(), unknowns.sound_scale - 1, settings_.sigma_sound);
}

void MotionPriors::addRest(const MotionUnknowns& unknowns, int index, bool first,
                           const ResidualSink& sink) const {
    const MotionNode& node = unknowns.nodes[static_cast<size_t>(index)];
    for (int s = 0; s < body_.size(); ++s) {
        const BodySegment& segment = body_.segment(s);
        const Matrix3d& R = node.R_world_segment[static_cast<size_t>(s)];
        if (segment.parent < 0 && !first) {
            addLevel(R, index, s, sink);
            continue;
        }
        const Matrix3d R_parent_segment =
            segment.parent < 0
                ? R
                : Matrix3d(node.R_world_segment[static_cast<size_t>(segment.parent)].transpose() * R);
        const Vector3d off = turnOf(segment.q_parent_rest.toRotationMatrix().transpose() * R_parent_segment);
        ResidualBlock block =
            blockOf(index, off, segment.parent < 0 ? settings_.sigma_level_rad : settings_.sigma_rest_rad);
        const Matrix3d by_turn = rightJacobian(off).inverse();
        block.addNode(MotionLayout::segment(s), by_turn);
        if (segment.parent < 0)
            block.weight.y() = informationOf(kYawSigma_rad);
        else
            block.addNode(MotionLayout::segment(segment.parent), -by_turn * R_parent_segment.transpose());
        sink(block);
    }
    if (!first)
        return;
    ResidualBlock place = blockOf(index, node.p_world_root_m, kRootPlaceSigma_m);
    place.addNode(0, Matrix3d::Identity());
    sink(place);
}

/// As upright as in the rest pose, whichever way it looks.
void MotionPriors::addLevel(const Matrix3d& R_world_segment, int node, int segment,
                            const ResidualSink& sink) const {
    const Vector3d up = R_world_segment.transpose() * Vector3d::UnitY();
    Matrix3d rows = Matrix3d::Zero();
    rows.topRows<2>() = across(body_.segment(segment).q_parent_rest.conjugate() * Vector3d::UnitY());
    ResidualBlock block = blockOf(node, rows * up, settings_.sigma_level_rad);
    block.rows = 2;
    block.addNode(MotionLayout::segment(segment), rows * skew(up));
    sink(block);
}

void MotionPriors::addJoints(const MotionUnknowns& unknowns, int index, const ResidualSink& sink) const {
    const MotionNode& node = unknowns.nodes[static_cast<size_t>(index)];
    const double sigma =
        settings_.sigma_give_rad * std::sqrt(std::max(1.0, settings_.correlation_s / settings_.step_s));
    for (int s = 0; s < body_.size(); ++s) {
        const BodySegment& segment = body_.segment(s);
        if (segment.type != JointType::kHinge && segment.type != JointType::kUniversal)
            continue;
        const Matrix3d R = node.R_world_segment[static_cast<size_t>(segment.parent)].transpose() *
                           node.R_world_segment[static_cast<size_t>(s)];
        // The last axis is the lower segment's; a hinge's does not move in the upper one, a universal joint's
        // stays at its angle to the first.
        const bool hinge = segment.type == JointType::kHinge;
        const Vector3d axis = segment.dof.back().axis, turned = R * axis;
        Matrix3d rows = Matrix3d::Zero();
        if (hinge)
            rows.topRows<2>() = across(axis);
        else
            rows.row(0) = segment.dof.front().axis;
        ResidualBlock block = blockOf(index, rows * turned, sigma);
        block.rows = hinge ? 2 : 1;
        if (!hinge)
            block.residual[0] -= segment.dof.front().axis.dot(axis);
        block.addNode(MotionLayout::segment(s), -rows * R * skew(axis));
        block.addNode(MotionLayout::segment(segment.parent), rows * skew(turned));
        sink(block);
    }
}

void MotionPriors::addRootStep(const MotionUnknowns& unknowns, int index, bool still,
                               const ResidualSink& sink) const {
    const auto k = static_cast<size_t>(index);
    const double speed = still ? kRootStillSpeed_m_per_s : kRootSpeed_m_per_s;
    ResidualBlock block =
        blockOf(index, unknowns.nodes[k + 1].p_world_root_m - unknowns.nodes[k].p_world_root_m,
                speed * settings_.step_s);
    block.addNode(layout_.nodeSize(), Matrix3d::Identity());
    block.addNode(0, -Matrix3d::Identity());
    sink(block);
}

void MotionPriors::addFollowing(const MotionUnknowns& unknowns, int index, int s,
                                const ResidualSink& sink) const {
    const auto k = static_cast<size_t>(index);
    const int parent = body_.segment(s).parent;
    const auto local = [&](size_t node) -> Matrix3d {
        const Matrix3d& R = unknowns.nodes[node].R_world_segment[static_cast<size_t>(s)];
        return parent < 0 ? R
                          : unknowns.nodes[node].R_world_segment[static_cast<size_t>(parent)].transpose() * R;
    };
    const Matrix3d before = local(k), after = local(k + 1), step = before.transpose() * after;
    const Vector3d turned = turnOf(step);
    ResidualBlock block = blockOf(index, turned, kUnheardTurn_rad);
    const Matrix3d by_after = rightJacobian(turned).inverse(), by_before = -by_after * step.transpose();
    const int next = layout_.nodeSize();
    block.addNode(next + MotionLayout::segment(s), by_after);
    block.addNode(MotionLayout::segment(s), by_before);
    if (parent >= 0) {
        block.addNode(next + MotionLayout::segment(parent), -by_after * after.transpose());
        block.addNode(MotionLayout::segment(parent), -by_before * before.transpose());
    }
    sink(block);
}

}  // namespace noctule
