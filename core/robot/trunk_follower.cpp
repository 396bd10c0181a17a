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

Result<TrunkFollower> TrunkFollower::make(const RobotModel& model, const RobotProfile& profile, double dt_s) {
    if (profile.trunk_joints.empty() || profile.arms.empty())
        return Error{ErrorKind::kUnusable, "robot " + profile.robot + " has no joints in its trunk",
                     "Leave --trunk out, or name them in the profile"};
    auto chain = Chain::make(model, profile.trunk_base, profile.trunk_tip);
    if (!chain)
        return chain.error();
    TrunkFollower made(std::move(*chain));
    ChainState state;
    const Chain& own = made.chain_;
    own.forward(JointVector::Zero(own.size()), state);
    // Body axes at all joints 0, in both links.
    made.R_tip_body_ =
        placeAtZero(model, model.findLink(profile.trunk_tip), model.findLink(profile.arms.front().base))
            .linear() *
        profile.arms.front().R_base_body;
    made.R_base_body_ = state.R_base_tip * made.R_tip_body_;
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const double acceleration = profile.max_acceleration > 0 ? profile.max_acceleration : kEndless;
    const double jerk = profile.max_acceleration > 0 && profile.max_jerk > 0 ? profile.max_jerk : kEndless;
    for (const ChainJoint& joint : own.joints()) {
        const double speed =
            joint.max_speed > kHighestSpeed_rad_per_s ? kUsualSpeed_rad_per_s : joint.max_speed;
        made.limiters_.emplace_back(JointLimits{joint.lower, joint.upper, speed, acceleration, jerk}, dt_s);
        made.motion_.push_back({std::clamp(0.0, joint.lower, joint.upper), 0, 0});
    }
    return made;
}

JointVector TrunkFollower::wishFor(const Matrix3d& R_hips_chest, int most_iterations) const {
    JointVector last(chain_.size());
    for (int i = 0; i < chain_.size(); ++i)
        last[i] = motion_[static_cast<size_t>(i)].place;
    JointVector q = last;
    const Matrix3d R_base_tip = R_base_body_ * R_hips_chest * R_tip_body_.transpose();
    TrunkCost cost(chain_, R_base_tip, last);
    solveInBox(cost, chain_.lower(), chain_.upper(), {most_iterations, 1e-6, 1e-6}, q,
               [](double) { return false; });
    return q;
}

void TrunkFollower::settle(const Matrix3d& R_hips_chest) {
    const JointVector q = wishFor(R_hips_chest, 100);
    for (int i = 0; i < chain_.size(); ++i)
        motion_[static_cast<size_t>(i)] = {q[i], 0, 0};
}

void TrunkFollower::follow(const Matrix3d& R_hips_chest) {
    const JointVector wish = wishFor(R_hips_chest, 5);
    for (int i = 0; i < chain_.size(); ++i) {
        const auto at = static_cast<size_t>(i);
        motion_[at] = limiters_[at].after(motion_[at], limiters_[at].approach(motion_[at], wish[i], 0));
    }
}

}  // namespace noctule::robot
