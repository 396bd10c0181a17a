// SPDX-License-Identifier: Apache-2.0
#include "core/robot/arm_follower.h"

#include <cmath>
#include <limits>

#include "core/math/rotation.h"
#include "core/robot/bounded_least_squares.h"
#include "core/robot/inverse_kinematics.h"

namespace noctule::robot {
namespace {

constexpr int kSettlingIterations = 200, kFollowingIterations = 5;

/// The cost of the room's README, with all targets in the base's frame.
class ArmCost {
public:
    ArmCost(const RobotArm& arm, const MappingWeights& weights, double scale, const ArmPose& pose,
            const JointVector& last)
        : arm_(arm), weights_(weights), last_(last) {
        const Matrix3d& R = arm.profile.R_base_body;
        upper_ = R * pose.upper;
        forearm_ = R * pose.forearm;
        wrist_ = R * (scale * pose.wrist_m);
        const Matrix3d R_reference = arm.profile.limb == Limb::kLeg
                                         ? Matrix3d::Identity()
                                         : PerformerArms::referenceForearm(arm.profile.side);
        R_tip_ = R * pose.R_hand * R_reference.transpose() * arm.R_body_tip;
        const double sigma = weights.wrist_per_arm * scale;
        wrist_weight_ = 1 / (sigma * sigma);
    }

    void operator()(const JointVector& q, LinearisedCost& at) {
        const Chain& chain = arm_.chain;
        chain.forward(q, state_);
        at.clear(chain.size());
        const RobotArm::Points points = arm_.points(state_);
        chain.pointJacobian(state_, arm_.shoulder - 1, points.shoulder, J_shoulder_);
        chain.pointJacobian(state_, arm_.elbow - 1, points.elbow, J_elbow_);
        chain.pointJacobian(state_, arm_.wrist < 0 ? arm_.elbow : arm_.wrist - 1, points.wrist, J_wrist_);
        addDirection(points.elbow - points.shoulder, upper_, J_elbow_ - J_shoulder_, at);
        addDirection(points.wrist - points.elbow, forearm_, J_wrist_ - J_elbow_, at);
        if (arm_.p_base_centre_m)
            at.add(wrist_weight_, Vector3d(points.wrist - *arm_.p_base_centre_m - wrist_), J_wrist_);
        else
            at.add(wrist_weight_, Vector3d(points.wrist - points.shoulder - wrist_), J_wrist_ - J_shoulder_);
        if (weights_.hand > 0 && arm_.wrist >= 0) {
            const TurnError turn = turnError(R_tip_, state_.R_base_tip);
            chain.turnJacobian(state_, chain.size() - 1, J_wrist_);
            J_elbow_.noalias() = turn.by_turn * J_wrist_;
            at.add(weights_.hand, turn.error, J_elbow_);
        }
        at.cost += weights_.stay * (q - last_).squaredNorm() / 2;
        at.gradient += weights_.stay * (q - last_);
        at.hessian.diagonal().array() += weights_.stay;
    }

private:
    void addDirection(const Vector3d& along, const Vector3d& wanted, const PointJacobian& J,
                      LinearisedCost& at) {
        const double length = along.norm();
        const Vector3d u = along / length;
        J_direction_.noalias() = (Matrix3d::Identity() - u * u.transpose()) / length * J;
        at.add(weights_.posture, Vector3d(u - wanted), J_direction_);
    }

    const RobotArm& arm_;
    const MappingWeights& weights_;
    const JointVector& last_;
    Vector3d upper_, forearm_, wrist_;
    Matrix3d R_tip_;
    double wrist_weight_ = 0;
    ChainState state_;
    PointJacobian J_shoulder_, J_elbow_, J_wrist_, J_direction_;
};

double angleDeg(const Vector3d& a, const Vector3d& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

}  // namespace

std::vector<StepLimiter> limitersOf(const RobotArm& arm, const RobotProfile& profile, double dt_s) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    std::vector<StepLimiter> limiters;
    for (int i = 0; i < arm.chain.size(); ++i) {
        const ChainJoint& joint = arm.chain.joint(i);
        const double jerk =
            profile.max_jerk > 0 && profile.max_acceleration > 0 ? profile.max_jerk : kEndless;
        limiters.emplace_back(
            JointLimits{joint.lower, joint.upper, arm.profile.max_speed[static_cast<size_t>(i)],
                        profile.max_acceleration > 0 ? profile.max_acceleration : kEndless, jerk},
            dt_s);
    }
    return limiters;
}

ArmCommand measured(const RobotArm& arm, double scale, const JointVector& q, const ArmPose& pose) {
    ChainState state;
    arm.chain.forward(q, state);
    const RobotArm::Points points = arm.points(state);
    const Matrix3d& R = arm.profile.R_base_body;
    ArmCommand command;
    command.q = q;
    command.upper_deg = angleDeg(points.elbow - points.shoulder, R * pose.upper);
    command.forearm_deg = angleDeg(points.wrist - points.elbow, R * pose.forearm);
    const Vector3d from = arm.p_base_centre_m.value_or(points.shoulder);
    command.wrist_mm = 1e3 * (points.wrist - from - R * (scale * pose.wrist_m)).norm();
    return command;
}

ArmFollower::ArmFollower(const RobotArm& arm, const RobotProfile& profile, double human_length_m, double dt_s)
    : arm_(arm),
      weights_(arm.profile.limb == Limb::kLeg ? weightsOfLegs() : profile.weights),
      scale_(arm.length_m / human_length_m),
      dt_s_(dt_s),
      limiters_(limitersOf(arm, profile, dt_s)) {
    for (Eigen::Index i = 0; i < arm_.reference.size(); ++i)
        motion_.push_back({arm_.reference[i], 0, 0});
}

JointVector ArmFollower::places() const {
    JointVector q(static_cast<Eigen::Index>(motion_.size()));
    for (size_t i = 0; i < motion_.size(); ++i)
        q[static_cast<Eigen::Index>(i)] = motion_[i].place;
    return q;
}

JointVector ArmFollower::wishFor(const ArmPose& pose, const JointVector& lower, const JointVector& upper,
                                 int most_iterations) const {
    const JointVector last = places();
    JointVector q = last.cwiseMax(lower).cwiseMin(upper);
    ArmCost cost(arm_, weights_, scale_, pose, last);
    solveInBox(cost, lower, upper, {most_iterations, 1e-5, 1e-6}, q, [](double) { return false; });
    return q;
}

void ArmFollower::settle(const ArmPose& pose) {
    const JointVector lower = arm_.chain.lower(), upper = arm_.chain.upper();
    for (int round = 0; round < 10; ++round) {  // each forgets where the one before began
        const JointVector q = wishFor(pose, lower, upper, kSettlingIterations);
        for (size_t i = 0; i < motion_.size(); ++i)
            motion_[i] = {q[static_cast<Eigen::Index>(i)], 0, 0};
    }
    has_wish_ = false;
}

ArmCommand ArmFollower::follow(const ArmPose& pose) {
    const auto size = static_cast<Eigen::Index>(motion_.size());
    JointVector lower(size), upper(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto at = static_cast<size_t>(i);
        const double step = arm_.profile.max_speed[at] * dt_s_;
        lower[i] = std::max(arm_.chain.joint(static_cast<int>(i)).lower, motion_[at].place - step);
        upper[i] = std::min(arm_.chain.joint(static_cast<int>(i)).upper, motion_[at].place + step);
        lower[i] = std::min(lower[i], upper[i]);
    }
    const JointVector wish = wishFor(pose, lower, upper, kFollowingIterations);
    bool is_limited = false;
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto at = static_cast<size_t>(i);
        const double wish_speed = has_wish_ ? (wish[i] - last_wish_[i]) / dt_s_ : 0;
        const double command = limiters_[at].approach(motion_[at], wish[i], wish_speed);
        const double slack = 1e-9 + 1e-6 * (upper[i] - lower[i]);
        is_limited |= std::abs(command - wish[i]) > slack || wish[i] <= lower[i] || wish[i] >= upper[i];
        motion_[at] = limiters_[at].after(motion_[at], command);
    }
    last_wish_ = wish;
    has_wish_ = true;
    return commandFor(pose, is_limited);
}

ArmCommand ArmFollower::hold(const ArmPose& pose) {
    for (size_t i = 0; i < motion_.size(); ++i)
        motion_[i] = limiters_[i].after(motion_[i], limiters_[i].brake(motion_[i]));
    has_wish_ = false;
    return commandFor(pose, false);
}

ArmCommand ArmFollower::commandFor(const ArmPose& pose, bool is_limited) const {
    ArmCommand command = measured(arm_, scale_, places(), pose);
    command.is_limited = is_limited;
    return command;
}

}  // namespace noctule::robot
