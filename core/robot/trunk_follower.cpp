// SPDX-License-Identifier: Apache-2.0
#include "core/robot/trunk_follower.h"

#include <limits>

#include "core/robot/bounded_least_squares.h"
#include "core/robot/inverse_kinematics.h"

namespace noctule::robot {
namespace {

constexpr double kStayOfTrunk = 1e-4;

class TrunkCost {
public:
    TrunkCost(const Chain& chain, const Matrix3d& R_base_tip, const JointVector& last)
        : chain_(chain), R_(R_base_tip), last_(last) {}

    void operator()(const JointVector& q, LinearisedCost& at) {
        chain_.forward(q, state_);
        at.clear(chain_.size());
        const TurnError turn = turnError(R_, state_.R_base_tip);
        chain_.turnJacobian(state_, chain_.size() - 1, J_turn_);
        J_.noalias() = turn.by_turn * J_turn_;
        at.add(1, turn.error, J_);
        at.cost += kStayOfTrunk * (q - last_).squaredNorm() / 2;
        at.gradient += kStayOfTrunk * (q - last_);
        at.hessian.diagonal().array() += kStayOfTrunk;
    }

private:
    const Chain& chain_;
    Matrix3d R_;
    const JointVector& last_;
    ChainState state_;
    PointJacobian J_, J_turn_;
};

}  // namespace

Result<RobotTrunk> makeTrunk(const RobotModel& model, const RobotProfile& profile) {
    if (profile.trunk_joints.empty() || profile.arms.empty())
        return Error{ErrorKind::kUnusable, "robot " + profile.robot + " has no joints in its trunk",
                     "Drive its arms alone, or name the joints in the profile"};
    auto chain = Chain::make(model, profile.trunk_base, profile.trunk_tip);
    if (!chain)
        return chain.error();
    RobotTrunk trunk{std::move(*chain), {}};
    for (const ChainJoint& joint : trunk.chain.joints())
        trunk.max_speed.push_back(usableSpeed(joint.max_speed));
    ChainState state;
    trunk.chain.forward(JointVector::Zero(trunk.chain.size()), state);
    trunk.R_tip_body =
        placeAtZero(model, model.findLink(profile.trunk_tip), model.findLink(profile.arms.front().base))
            .linear() *
        profile.arms.front().R_base_body;
    trunk.R_base_body = state.R_base_tip * trunk.R_tip_body;
    return trunk;
}

TrunkFollower::TrunkFollower(const RobotTrunk& trunk, const RobotProfile& profile, double dt_s)
    : trunk_(trunk) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const double acceleration = profile.max_acceleration > 0 ? profile.max_acceleration : kEndless;
    const double jerk = profile.max_acceleration > 0 && profile.max_jerk > 0 ? profile.max_jerk : kEndless;
    for (int i = 0; i < trunk.chain.size(); ++i) {
        const ChainJoint& joint = trunk.chain.joint(i);
        limiters_.emplace_back(JointLimits{joint.lower, joint.upper, trunk.max_speed[static_cast<size_t>(i)],
                                           acceleration, jerk},
                               dt_s);
        motion_.push_back({std::clamp(0.0, joint.lower, joint.upper), 0, 0});
    }
}

JointVector TrunkFollower::places() const {
    JointVector q(trunk_.chain.size());
    for (int i = 0; i < trunk_.chain.size(); ++i)
        q[i] = motion_[static_cast<size_t>(i)].place;
    return q;
}

JointVector TrunkFollower::wishFor(const Matrix3d& R_hips_chest, int most_iterations) const {
    const JointVector last = places();
    JointVector q = last;
    const Matrix3d R_base_tip = trunk_.R_base_body * R_hips_chest * trunk_.R_tip_body.transpose();
    TrunkCost cost(trunk_.chain, R_base_tip, last);
    solveInBox(cost, trunk_.chain.lower(), trunk_.chain.upper(), {most_iterations, 1e-6, 1e-6}, q,
               [](double) { return false; });
    return q;
}

void TrunkFollower::settle(const Matrix3d& R_hips_chest) {
    const JointVector q = wishFor(R_hips_chest, 100);
    for (int i = 0; i < trunk_.chain.size(); ++i)
        motion_[static_cast<size_t>(i)] = {q[i], 0, 0};
}

void TrunkFollower::follow(const Matrix3d& R_hips_chest) {
    const JointVector wish = wishFor(R_hips_chest, 5);
    for (int i = 0; i < trunk_.chain.size(); ++i) {
        const auto at = static_cast<size_t>(i);
        motion_[at] = limiters_[at].after(motion_[at], limiters_[at].approach(motion_[at], wish[i], 0));
    }
}

}  // namespace noctule::robot
