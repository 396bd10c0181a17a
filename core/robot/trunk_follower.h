// SPDX-License-Identifier: Apache-2.0
// A robot's waist follows the turn of the performer's chest against the hips, as far as its joints go.
#pragma once

#include "core/robot/profile.h"
#include "core/robot/step_limiter.h"

namespace noctule::robot {

/// The joints between a robot's legs and its arms.
struct RobotTrunk {
    Chain chain;
    std::vector<double> max_speed;  ///< rad/s, per joint
    /// Body axes (x left, y up, z forward) of hips and chest in the links around it, at all joints 0.
    Matrix3d R_base_body = Matrix3d::Identity(), R_tip_body = Matrix3d::Identity();
};

/// kUnusable when the profile names no joint of a trunk.
Result<RobotTrunk> makeTrunk(const RobotModel& model, const RobotProfile& profile);

class TrunkFollower {
public:
    TrunkFollower(const RobotTrunk& trunk, const RobotProfile& profile, double dt_s);

    void settle(const Matrix3d& R_hips_chest);
    void follow(const Matrix3d& R_hips_chest);
    const RobotTrunk& trunk() const { return trunk_; }
    const std::vector<JointMotion>& motion() const { return motion_; }
    JointVector places() const;

private:
    JointVector wishFor(const Matrix3d& R_hips_chest, int most_iterations) const;

    RobotTrunk trunk_;
    std::vector<StepLimiter> limiters_;
    std::vector<JointMotion> motion_;
};

}  // namespace noctule::robot
