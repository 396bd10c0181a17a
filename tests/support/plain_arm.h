// SPDX-License-Identifier: Apache-2.0
// A robot with one arm as a person has it on the right, and its profile.
#pragma once

#include <string>

#include "core/robot/profile.h"

namespace noctule::test {

inline constexpr double kPlainArmSpeed = 2;  ///< rad/s, of every joint

/// The right arm of a person: shoulder, upper arm along -z, forearm ahead, in the axes of REP 103. With a
/// waist its base turns about z on the link "hips".
inline std::string plainArmUrdf(bool has_waist = false) {
    struct One {
        const char *name, *axis, *origin;
    };
    const One joints[] = {{"s0", "0 1 0", "0 -0.2 1.4"}, {"s1", "1 0 0", "0 0 0"},
                          {"s2", "0 0 1", "0 0 0"},      {"e", "0 1 0", "0 0 -0.3"},
                          {"f", "0 0 1", "0 0 -0.1"},    {"w0", "0 1 0", "0 0 -0.2"},
                          {"w1", "1 0 0", "0 0 0"}};
    std::string text = "<robot name=\"arm\"><link name=\"l0\"/>";
    if (has_waist)
        text +=
            "<link name=\"hips\"/><joint name=\"waist\" type=\"revolute\"><parent link=\"hips\"/>"
            "<child link=\"l0\"/><axis xyz=\"0 0 1\"/>"
            "<limit lower=\"-0.9\" upper=\"0.9\" velocity=\"2\" effort=\"1\"/></joint>";
    int number = 0;
    for (const One& joint : joints) {
        const std::string parent = "l" + std::to_string(number), child = "l" + std::to_string(++number);
        text += "<link name=\"" + child + "\"/><joint name=\"" + joint.name +
                "\" type=\"revolute\"><parent link=\"" + parent + "\"/><child link=\"" + child +
                "\"/><axis xyz=\"" + joint.axis + "\"/><origin xyz=\"" + joint.origin +
                "\"/><limit lower=\"-2.5\" upper=\"2.5\" velocity=\"2\" effort=\"1\"/></joint>";
    }
    return text + "</robot>";
}

inline robot::RobotProfile plainArmProfile(bool has_waist = false) {
    robot::ArmProfile arm;
    arm.name = "right";
    arm.base = "l0";
    arm.tip = "l7";
    arm.shoulder_joint = "s0";
    arm.elbow_joint = "e";
    arm.wrist_joint = "w0";
    arm.R_base_body.col(0) = Vector3d::UnitY();  // left
    arm.R_base_body.col(1) = Vector3d::UnitZ();
    arm.R_base_body.col(2) = Vector3d::UnitX();
    arm.reference_rad = {0, 0, 0, -1.5, 0, 0, 0};
    arm.max_speed.assign(7, kPlainArmSpeed);
    robot::RobotProfile profile;
    profile.robot = "arm";
    profile.arms = {arm};
    profile.clearance_m = 0;  // it has no trunk that the arm could touch
    if (has_waist) {
        profile.trunk_joints = {"waist"};
        profile.trunk_base = "hips";
        profile.trunk_tip = "l0";
    }
    return profile;
}

}  // namespace noctule::test
