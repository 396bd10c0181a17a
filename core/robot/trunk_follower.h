// SPDX-License-Identifier: Apache-2.0
// A robot's waist follows the turn of the performer's chest against the hips, as far as its joints go.
#pragma once

#include "core/robot/profile.h"
#include "core/robot/step_limiter.h"

namespace noctule::robot {

class TrunkFollower {
public:
    /// kUnusable when the profile names no joint of a trunk.
    static Result<TrunkFollower> make(const RobotModel& model, const RobotProfile& profile, double dt_s);

    void settle(const Matrix3d& R_hips_chest);
    void follow(const Matrix3d& R_hips_chest);
    const Chain& chain() const { return chain_; }
    const std::vector<JointMotion>& motion() const { return motion_; }

private:
    TrunkFollower(Chain chain) : chain_(std::move(chain)) {}
    JointVector wishFor(const Matrix3d& R_hips_chest, int most_iterations) const;

    Chain chain_;
    Matrix3d R_base_body_ = Matrix3d::Identity(), R_tip_body_ = Matrix3d::Identity();
    std::vector<StepLimiter> limiters_;
    std::vector<JointMotion> motion_;
};

}  // namespace noctule::robot
