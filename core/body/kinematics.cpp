// SPDX-License-Identifier: Apache-2.0
// World coordinates throughout. For link i with pivot c, parent angular velocity w_p and acceleration, let
// r = P - c, v_rel the velocity of P relative to the parent's frame and a_rel likewise. A perturbation of
// coordinate i turns everything from link i on rigidly by phi = axis * delta about c, relative motion
// included, while the parent's motion stays; this gives all derivatives in closed form.
#include "core/body/kinematics.h"

#include "core/math/rotation.h"

namespace noctule {
namespace {

const Vector3d kZero = Vector3d::Zero();

/// Rate of a link relative to its parent, in its own frame.
Vector3d relativeRate(const Link& link, const Eigen::VectorXd& rate) {
    switch (link.type) {
        case LinkType::kHinge:
            return link.axis * rate[link.first];
        case LinkType::kBall:
            return rate.segment<3>(link.first);
        case LinkType::kFree:
            return link.count == 6 ? Vector3d(rate.segment<3>(link.first + 3)) : kZero;
        case LinkType::kFixed:
            break;
    }
    return kZero;
}

int rotationCount(const Link& link) {
    return link.type == LinkType::kFree ? link.count - 3 : link.count;
}

}  // namespace

void ChainMotion::evaluate(const KinematicTree& tree, const MotionState& state, int link_index,
                           double offset_s) {
    frames_.clear();
    coordinates_.clear();
    turns_.clear();
    offset_s_ = offset_s;
    const double half_square = 0.5 * offset_s * offset_s;
    for (int index : tree.chain(link_index)) {
        const Link& link = tree.link(index);
        const Vector3d relative_accel = relativeRate(link, state.accel);
        const Vector3d rate_now = relativeRate(link, state.rate);
        const Vector3d relative_rate = rate_now + offset_s * relative_accel;
        const Vector3d turn = offset_s * rate_now + half_square * relative_accel;
        Matrix3d R_parent_link = state.q_parent_link[static_cast<size_t>(index)].toRotationMatrix();
        if (offset_s != 0)
            R_parent_link = R_parent_link * expQuaternion(turn).toRotationMatrix();

        Frame frame;
        if (frames_.empty()) {
            frame.p_m = state.p_world_root;
            frame.v_m_per_s = frame.a_m_per_s2 = kZero;
            if (link.type == LinkType::kFree) {
                frame.a_m_per_s2 = state.accel.segment<3>(link.first);
                frame.v_m_per_s = state.rate.segment<3>(link.first) + offset_s * frame.a_m_per_s2;
                frame.p_m += offset_s * state.rate.segment<3>(link.first) + half_square * frame.a_m_per_s2;
            }
            frame.R_world_link = R_parent_link;
            frame.omega_rad_per_s = R_parent_link * relative_rate;
            frame.alpha_rad_per_s2 = R_parent_link * relative_accel;
        } else {
            const Frame& parent = frames_.back();
            const Vector3d arm = parent.R_world_link * link.offset_m;
            const Vector3d swing = parent.omega_rad_per_s.cross(arm);
            frame.p_m = parent.p_m + arm;
            frame.v_m_per_s = parent.v_m_per_s + swing;
            frame.a_m_per_s2 =
                parent.a_m_per_s2 + parent.alpha_rad_per_s2.cross(arm) + parent.omega_rad_per_s.cross(swing);
            frame.R_world_link = parent.R_world_link * R_parent_link;
            const Vector3d relative = frame.R_world_link * relative_rate;
            frame.omega_rad_per_s = parent.omega_rad_per_s + relative;
            frame.alpha_rad_per_s2 = parent.alpha_rad_per_s2 + frame.R_world_link * relative_accel +
                                     parent.omega_rad_per_s.cross(relative);
        }
        const int position = static_cast<int>(frames_.size());
        frames_.push_back(frame);

        if (link.type == LinkType::kFree)
            for (int i = 0; i < 3; ++i)
                coordinates_.push_back({link.first + i, true, Vector3d::Unit(i), position});
        if (link.type == LinkType::kHinge) {
            coordinates_.push_back({link.first, false, frame.R_world_link * link.axis, position});
        } else if (rotationCount(link) == 3) {
            if (offset_s != 0)
                turns_.push_back({static_cast<int>(coordinates_.size()), 3,
                                  expQuaternion(turn).toRotationMatrix().transpose(), rightJacobian(turn)});
            for (int i = 0; i < 3; ++i)
                coordinates_.push_back(
                    {link.first + link.count - 3 + i, false, frame.R_world_link.col(i), position});
        }
    }
}

ChainMotion::Point ChainMotion::point(const Vector3d& p_link_point_m) const {
    const Frame& f = frames_.back();
    const Vector3d arm = f.R_world_link * p_link_point_m;
    const Vector3d swing = f.omega_rad_per_s.cross(arm);
    return {f.p_m + arm, f.v_m_per_s + swing,
            f.a_m_per_s2 + f.alpha_rad_per_s2.cross(arm) + f.omega_rad_per_s.cross(swing)};
}

const Vector3d& ChainMotion::parentOmega(const Coordinate& c) const {
    return c.frame == 0 ? kZero : frames_[static_cast<size_t>(c.frame) - 1].omega_rad_per_s;
}

const Vector3d& ChainMotion::parentAlpha(const Coordinate& c) const {
    return c.frame == 0 ? kZero : frames_[static_cast<size_t>(c.frame) - 1].alpha_rad_per_s2;
}

ChainMotion::PointDerivative ChainMotion::pointDerivative(const Coordinate& c, const Point& point) const {
    if (c.translation)
        return {c.axis, kZero, c.axis, kZero, kZero, c.axis};
    const Frame& pivot = frames_[static_cast<size_t>(c.frame)];
    const Vector3d& omega = parentOmega(c);
    const Vector3d& alpha = parentAlpha(c);
    const Vector3d r = point.p_m - pivot.p_m;
    const Vector3d swing = omega.cross(r);
    const Vector3d v_rel = point.v_m_per_s - pivot.v_m_per_s - swing;
    const Vector3d a_rel =
        point.a_m_per_s2 - pivot.a_m_per_s2 - alpha.cross(r) - omega.cross(swing) - 2 * omega.cross(v_rel);
    const Vector3d lever = c.axis.cross(r);
    const Vector3d carried = omega.cross(lever);
    const Vector3d own =
        pivot.omega_rad_per_s - omega;  // angular velocity of the link relative to its parent

    PointDerivative d;
    d.p_theta = lever;
    d.v_rate = lever;
    d.a_accel = lever;
    d.v_theta = carried + c.axis.cross(v_rel);
    d.a_theta = alpha.cross(lever) + omega.cross(carried) + 2 * omega.cross(c.axis.cross(v_rel)) +
                c.axis.cross(a_rel);
    d.a_rate =
        2 * carried + c.axis.cross(own.cross(r)) + own.cross(lever) + 2 * c.axis.cross(v_rel - own.cross(r));
    return d;
}

Vector3d ChainMotion::omegaByTheta(const Coordinate& c) const {
    return c.translation ? kZero : Vector3d(c.axis.cross(end().omega_rad_per_s - parentOmega(c)));
}

Vector3d ChainMotion::rotationByTheta(const Coordinate& c) const {
    return c.translation ? kZero : c.axis;
}

void ChainMotion::transportToState(Columns& columns) const {
    if (offset_s_ == 0)
        return;
    const double t = offset_s_, half_square = 0.5 * t * t;
    const Eigen::MatrixXd theta_later = columns.theta;
    // Hinges and translations: theta' = theta + t rate + t^2/2 accel, rate' = rate + t accel.
    columns.accel += t * columns.rate + half_square * theta_later;
    columns.rate += t * theta_later;
    for (const Turn& turn : turns_) {
        const auto later = theta_later.middleCols(turn.first_column, turn.count);
        const Eigen::MatrixXd by_rate = later * (turn.right_jacobian - Matrix3d::Identity());
        columns.theta.middleCols(turn.first_column, turn.count) = later * turn.exp_u_transposed;
        columns.rate.middleCols(turn.first_column, turn.count) += t * by_rate;
        columns.accel.middleCols(turn.first_column, turn.count) += half_square * by_rate;
    }
}

}  // namespace noctule
