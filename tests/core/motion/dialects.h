// SPDX-License-Identifier: Apache-2.0
// One motion as other programs write it: other zero pose, other axes, other names.
#pragma once

#include <map>

#include "tests/core/motion/made_motion.h"

namespace noctule::test {

/// A person who walks, bends, turns and reaches, with bent elbows and knees; does not repeat itself. Our
/// names, about our T pose.
inline Pose livelyPose(const Skeleton& skeleton, double t_s) {
    Pose pose = skeleton.zeroPose();
    pose.p_world_root = {0.3 * std::sin(0.4 * t_s), 0.95 + 0.02 * std::sin(9 * t_s), 1.1 * t_s};
    const auto turn = [&](const char* joint, const Vector3d& axis, double angle_rad) {
        Quaterniond& q = pose.q_parent_joint[static_cast<size_t>(skeleton.find(joint))];
        q = q * axisAngle(axis, angle_rad);
    };
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const double step = 2 * std::numbers::pi * (0.9 * t_s + 0.05 * std::sin(0.7 * t_s));
    const double stride = 0.45 + 0.1 * std::sin(0.37 * t_s);
    turn("Hips", y, 0.6 * std::sin(0.23 * t_s * t_s / 4));
    turn("Hips", x, 0.08);
    turn("Spine", x, 0.15 + 0.1 * std::sin(0.9 * t_s));
    turn("Chest", y, 0.12 * std::sin(step));
    turn("Head", y, 0.4 * std::sin(0.6 * t_s + 1));
    for (const auto& [side, sign] : {std::pair<std::string, double>{"Left", 1.0}, {"Right", -1.0}}) {
        const double phase = sign * std::sin(step);
        turn((side + "UpLeg").c_str(), x, -stride * phase - 0.1);
        turn((side + "Leg").c_str(), x, 0.35 + 0.3 * std::sin(step * sign + 1));
        turn((side + "Foot").c_str(), x, 0.2 * phase);
        turn((side + "Arm").c_str(), z, -sign * 1.15);
        turn((side + "Arm").c_str(), y, -sign * (0.3 * phase + 0.25 * std::sin((1.1 + 0.3 * sign) * t_s)));
        turn((side + "ForeArm").c_str(), y, -sign * (0.5 + 0.3 * std::sin(0.8 * t_s + sign)));
        turn((side + "Hand").c_str(), z, 0.2 * std::sin(1.3 * t_s));
    }
    return pose;
}

inline TimedMotion lively(double from_s, double seconds, double frames_per_second) {
    TimedMotion motion{skeleton(), {}};
    for (int i = 0; i < seconds * frames_per_second; ++i)
        motion.frames.push_back({std::llround(i * 1e9 / frames_per_second),
                                 livelyPose(motion.skeleton, from_s + i / frames_per_second),
                                 {}});
    return motion;
}

/// The same movement of every segment about another zero pose: `q_zero` per joint of ours is its world
/// orientation there, `q_axes` the constant turn of its axes on top of that (identity: a BVH file, whose
/// frames are parallel in its zero pose).
inline TimedMotion inDialect(const TimedMotion& motion, const std::map<std::string, Quaterniond>& q_zero,
                             bool along_x, const std::map<std::string, std::string>& names) {
    const Skeleton& ours = motion.skeleton;
    const auto zeroOf = [&](int j) {
        const auto found = q_zero.find(ours.joint(j).name);
        return found == q_zero.end() ? Quaterniond::Identity() : found->second;
    };
    // q_world_theirs = q_world_ours * q_ours_theirs; bones in their frames point where the zero pose shows.
    std::vector<Quaterniond> q_ours_theirs;
    std::vector<Joint> joints = ours.joints();
    for (int j = 0; j < ours.size(); ++j) {
        Quaterniond q = zeroOf(j).conjugate();
        if (along_x) {  // the bone to the first child lies along the joint's x axis, turned about it by 0.7
            Vector3d bone = ours.joint(j).end_m.value_or(Vector3d::UnitY());
            for (int child = ours.size() - 1; child > j; --child)
                if (ours.joint(child).parent == j)
                    bone = ours.joint(child).offset_m;
            q = smallestRotation(Vector3d::UnitX(), bone) * axisAngle(Vector3d::UnitX(), 0.7);
        }
        q_ours_theirs.push_back(q);
    }
    for (int j = 0; j < ours.size(); ++j) {
        Joint& joint = joints[static_cast<size_t>(j)];
        if (joint.parent >= 0)
            joint.offset_m = q_ours_theirs[static_cast<size_t>(joint.parent)].conjugate() * joint.offset_m;
        if (joint.end_m)
            joint.end_m = q_ours_theirs[static_cast<size_t>(j)].conjugate() * *joint.end_m;
        joint.type = j == 0 ? JointType::kFree : JointType::kBall;
        const auto name = names.find(joint.name);
        joint.name = name == names.end() ? joint.name : name->second;
        joint.dof.clear();
        if (j > 0)
            joint.dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
        joint.aliases.clear();
    }
    TimedMotion theirs{Skeleton::make(joints).value(), motion.frames};
    for (TimedPose& frame : theirs.frames) {
        const GlobalPose global = globalPose(ours, *frame.pose);
        for (int j = 0; j < ours.size(); ++j) {
            const auto i = static_cast<size_t>(j);
            const Quaterniond q_world = global.q_world_joint[i] * q_ours_theirs[i];
            const int parent = ours.joint(j).parent;
            const auto p = static_cast<size_t>(std::max(parent, 0));
            frame.pose->q_parent_joint[i] =
                parent < 0 ? q_world : (global.q_world_joint[p] * q_ours_theirs[p]).conjugate() * q_world;
        }
    }
    return theirs;
}

/// Arms lowered by 45 degrees.
inline std::map<std::string, Quaterniond> aPose() {
    std::map<std::string, Quaterniond> zero;
    for (const char* joint : {"Arm", "ForeArm", "Hand"}) {
        zero[std::string("Left") + joint] = axisAngle(Vector3d::UnitZ(), -std::numbers::pi / 4);
        zero[std::string("Right") + joint] = axisAngle(Vector3d::UnitZ(), std::numbers::pi / 4);
    }
    return zero;
}

/// Thighs forward, shins down, arms hanging.
inline std::map<std::string, Quaterniond> sittingPose() {
    std::map<std::string, Quaterniond> zero;
    for (const std::string side : {"Left", "Right"}) {
        zero[side + "UpLeg"] = axisAngle(Vector3d::UnitX(), -std::numbers::pi / 2);
        for (const char* joint : {"Arm", "ForeArm", "Hand"})
            zero[side + joint] =
                axisAngle(Vector3d::UnitZ(), (side == "Left" ? -1 : 1) * std::numbers::pi / 2);
    }
    return zero;
}

inline std::map<std::string, std::string> xsensNames() {
    std::map<std::string, std::string> names{{"Spine", "Chest"}, {"Chest", "Chest4"}};
    for (const std::string side : {"Left", "Right"})
        for (const auto& [ours, theirs] :
             {std::pair{"Shoulder", "Collar"}, std::pair{"Arm", "Shoulder"}, std::pair{"ForeArm", "Elbow"},
              std::pair{"Hand", "Wrist"}, std::pair{"UpLeg", "Hip"}, std::pair{"Leg", "Knee"},
              std::pair{"Foot", "Ankle"}, std::pair{"ToeBase", "Toe"}})
            names[side + ours] = side + theirs;
    return names;
}

}  // namespace noctule::test
