// SPDX-License-Identifier: Apache-2.0
// The baseline: the mapping of Miller, Jenkins, Kallmann, Mataric 2004, "Motion capture from inertial sensing
// for untethered humanoid teleoperation", section 5, to the letter. Two sensors, upper arm and forearm:
// q2_local = q1^-1 q2 (equation 16); Euler angles in the order of the robot's axes; offsets of the reference
// posture; signs by the direction of each axis. Five joints are driven, the wrist's two keep their offset.
// Nothing corrects shoulders whose axes do not meet, and without a sensor on the trunk a turn of the body
// turns the arm.
#pragma once

#include "core/math/euler.h"
#include "core/robot/profile.h"

namespace noctule::robot {

class MillerMapping {
public:
    /// kUnusable when three joints of the shoulder do not lie near three different axes of the body.
    static Result<MillerMapping> make(const RobotArm& arm);

    /// Joint values inside the limits of place; `previous`: angles run on from there.
    JointVector map(const ArmPose& pose);

private:
    struct Axis {
        int joint = -1;  ///< of the chain
        double sign = 1;
    };
    std::vector<Axis> upper_, forearm_;
    EulerOrder upper_order_ = kEulerXYZ, forearm_order_ = kEulerXYZ;
    Vector3d upper_angles_ = Vector3d::Zero(), forearm_angles_ = Vector3d::Zero();
    Side side_ = Side::kRight;
    JointVector offsets_, lower_, upper_limit_;
};

}  // namespace noctule::robot
