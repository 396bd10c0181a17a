// SPDX-License-Identifier: Apache-2.0
// Follows a performer's arm with a robot's: both segments' directions, the wrist scaled by the arms'
// lengths, the hand's turn. A few steps of Levenberg-Marquardt per frame from the last command, inside the
// joints' limits; it never restarts, and returns the best it finds with how far off that is.
#pragma once

#include "core/robot/profile.h"
#include "core/robot/step_limiter.h"

namespace noctule::robot {

struct ArmCommand {
    JointVector q;
    double upper_deg = 0, forearm_deg = 0;  ///< between the robot's and the performer's segments
    double wrist_mm = 0;                    ///< from the scaled place, in the robot's size
    bool is_limited = false;                ///< a limit of motion holds a joint back
};

class ArmFollower {
public:
    /// Begins at rest in the reference posture. `human_length_m`: the performer's arm.
    ArmFollower(const RobotArm& arm, const RobotProfile& profile, double human_length_m, double dt_s);

    /// The posture that suits the pose best, from the last one; no limit but those of place holds, and as
    /// many steps as it takes. For the first frame, where the robot is not moving yet.
    void settle(const ArmPose& pose);
    ArmCommand follow(const ArmPose& pose);
    /// Brings the joints to rest as fast as the limits allow.
    ArmCommand hold(const ArmPose& pose);

    const RobotArm& arm() const { return arm_; }
    const std::vector<JointMotion>& motion() const { return motion_; }
    void setMotion(const std::vector<JointMotion>& motion) { motion_ = motion; }

private:
    JointVector places() const;
    JointVector wishFor(const ArmPose& pose, const JointVector& lower, const JointVector& upper,
                        int most_iterations) const;
    ArmCommand commandFor(const ArmPose& pose, bool is_limited) const;

    RobotArm arm_;
    MappingWeights weights_;
    double scale_;
    double dt_s_;
    std::vector<StepLimiter> limiters_;
    std::vector<JointMotion> motion_;
    JointVector last_wish_;
    bool has_wish_ = false;
};

/// The joints' limits of motion: speeds of the profile, acceleration and jerk.
std::vector<StepLimiter> limitersOf(const RobotArm& arm, const RobotProfile& profile, double dt_s);

/// How far the arm in posture q is from the performer's.
ArmCommand measured(const RobotArm& arm, double scale, const JointVector& q, const ArmPose& pose);

}  // namespace noctule::robot
