// SPDX-License-Identifier: Apache-2.0
// One performance written in the many ways of programs: other zero poses, frames, axes, units and names. What
// a simulated take holds must be the same for all of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/body/bone_names.h"
#include "core/body/joint_names.h"
#include "core/figure/facing.h"
#include "core/figure/understood_motion.h"
#include "core/math/rotation.h"
#include "core/simulation/motion_fit.h"

namespace noctule::figure {

/// A person of 1.78 m who walks, turns the head and swings bent arms; HumanIK's names, T pose, metres. Own
/// numbers.
inline MotionClip walk(double seconds = 4, double rate_hz = 30) {
    struct Row {
        const char *name, *parent;
        Vector3d offset;
    };
    const std::vector<Row> rows = {
        {"Hips", "", {0, 0, 0}},
        {"Spine", "Hips", {0, 0.08, 0}},
        {"Spine1", "Spine", {0, 0.12, 0}},
        {"Spine2", "Spine1", {0, 0.13, 0}},
        {"Neck", "Spine2", {0, 0.2, 0}},
        {"Head", "Neck", {0, 0.1, 0.01}},
        {"LeftShoulder", "Spine2", {0.035, 0.14, 0.01}},
        {"LeftArm", "LeftShoulder", {0.13, 0.005, -0.01}},
        {"LeftForeArm", "LeftArm", {0.29, 0, 0}},
        {"LeftHand", "LeftForeArm", {0.24, 0, 0}},
        {"RightShoulder", "Spine2", {-0.035, 0.14, 0.01}},
        {"RightArm", "RightShoulder", {-0.13, 0.005, -0.01}},
        {"RightForeArm", "RightArm", {-0.29, 0, 0}},
        {"RightHand", "RightForeArm", {-0.24, 0, 0}},
        {"LeftUpLeg", "Hips", {0.085, -0.05, 0}},
        {"LeftLeg", "LeftUpLeg", {0, -0.42, 0}},
        {"LeftFoot", "LeftLeg", {0, -0.42, 0}},
        {"LeftToeBase", "LeftFoot", {0, -0.065, 0.13}},
        {"RightUpLeg", "Hips", {-0.085, -0.05, 0}},
        {"RightLeg", "RightUpLeg", {0, -0.42, 0}},
        {"RightFoot", "RightLeg", {0, -0.42, 0}},
        {"RightToeBase", "RightFoot", {0, -0.065, 0.13}},
    };
    std::vector<Joint> joints;
    std::map<std::string, int> index;
    for (const Row& row : rows) {
        Joint joint;
        joint.name = row.name;
        joint.parent = *row.parent ? index.at(row.parent) : -1;
        joint.offset_m = row.offset;
        joint.type = *row.parent ? JointType::kBall : JointType::kFree;
        if (*row.parent)
            joint.dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
        const std::string name = row.name;
        if (name == "Head")
            joint.end_m = Vector3d(0, 0.19, 0);
        if (name.ends_with("Hand"))
            joint.end_m = Vector3d(name.starts_with("Left") ? 0.17 : -0.17, 0, 0);
        if (name.ends_with("ToeBase"))
            joint.end_m = Vector3d(0, 0, 0.07);
        index[name] = static_cast<int>(joints.size());
        joints.push_back(joint);
    }
    MotionClip clip;
    clip.name = "walk";
    clip.frame_time_s = 1 / rate_hz;
    clip.skeleton = Skeleton::make(std::move(joints)).value();
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    for (int f = 0; f < static_cast<int>(std::lround(seconds * rate_hz)); ++f) {
        const double t = f / rate_hz, phase = 2 * std::numbers::pi * 0.9 * t;
        Pose pose = clip.skeleton.zeroPose();
        const auto set = [&](const std::string& joint, const Quaterniond& q) {
            pose.q_parent_joint[static_cast<size_t>(index.at(joint))] = q;
        };
        pose.p_world_root = {0.02 * std::sin(phase), 0.93 + 0.015 * std::sin(2 * phase), 1.2 * t};
        set("Hips", axisAngle(y, 0.06 * std::sin(phase)) * axisAngle(z, 0.02 * std::cos(phase)));
        set("Spine", axisAngle(x, 0.05) * axisAngle(y, -0.04 * std::sin(phase)));
        set("Spine2", axisAngle(y, -0.06 * std::sin(phase)) * axisAngle(x, 0.02 + 0.02 * std::sin(phase)));
        set("Head", axisAngle(y, 0.15 * std::sin(0.7 * phase)) * axisAngle(x, 0.05 * std::sin(phase)));
        for (const auto& [side, sign] : {std::pair{std::string("Left"), 1.0}, {std::string("Right"), -1.0}}) {
            const double swing = sign * std::sin(phase);
            set(side + "Shoulder", axisAngle(z, sign * 0.05));
            set(side + "Arm", axisAngle(x, -0.1 + 0.4 * swing) * axisAngle(z, -sign * 1.2));
            set(side + "ForeArm", axisAngle(y, -sign * (0.45 + 0.25 * swing)));
            set(side + "Hand", axisAngle(z, 0.05 * swing));
            set(side + "UpLeg", axisAngle(x, 0.02 + 0.45 * swing) * axisAngle(z, sign * 0.03));
            const double bend =
                0.5 + 0.45 * std::sin(phase * 1.0 + (sign > 0 ? 1.9 : 1.9 + std::numbers::pi));
            set(side + "Leg", axisAngle(x, bend));
            set(side + "Foot", axisAngle(x, -0.15 - 0.2 * swing) * axisAngle(y, sign * 0.03));
        }
        clip.frames.push_back(pose);
    }
    return clip;
}

/// The same performance with other joint frames: q_old_new per joint, constant.
inline MotionClip reframed(const MotionClip& clip, const std::vector<Quaterniond>& q_old_new) {
    std::vector<Joint> joints = clip.skeleton.joints();
    const auto above = [&](size_t j) {
        return joints[j].parent < 0 ? Quaterniond::Identity()
                                    : q_old_new[static_cast<size_t>(joints[j].parent)];
    };
    MotionClip made = clip;
    for (Pose& pose : made.frames)
        for (size_t j = 0; j < joints.size(); ++j)
            pose.q_parent_joint[j] =
                (above(j).conjugate() * pose.q_parent_joint[j] * q_old_new[j]).normalized();
    std::vector<Joint> turned = joints;
    for (size_t j = 0; j < joints.size(); ++j) {
        turned[j].offset_m = above(j).conjugate() * joints[j].offset_m;
        if (joints[j].end_m)
            turned[j].end_m = q_old_new[j].conjugate() * *joints[j].end_m;
    }
    for (std::vector<Vector3d>& places : made.p_parent_joint_m)
        for (size_t j = 1; j < joints.size(); ++j)
            places[j] = above(j).conjugate() * places[j];
    made.skeleton = Skeleton::make(std::move(turned)).value();
    return made;
}

/// The pose with these local rotations becomes the zero pose.
inline MotionClip withZeroPose(const MotionClip& clip, const std::map<std::string, Quaterniond>& rest) {
    Pose pose = clip.skeleton.zeroPose();
    for (const auto& [joint, q] : rest)
        pose.q_parent_joint[static_cast<size_t>(clip.skeleton.find(joint))] = q;
    std::vector<Quaterniond> frames;
    for (const Quaterniond& q : globalPose(clip.skeleton, pose).q_world_joint)
        frames.push_back(q.conjugate());
    return reframed(clip, frames);
}

/// Every joint's frame with `axis` along its bone, turned about it by an angle of its own; without tips.
inline MotionClip alongAxis(const MotionClip& clip, const Vector3d& axis,
                            const std::function<double(int)>& twist_rad, bool keeps_tips = false) {
    std::vector<Quaterniond> frames;
    for (int j = 0; j < clip.skeleton.size(); ++j) {
        Vector3d bone = Vector3d::Zero();
        for (int c = j + 1; c < clip.skeleton.size() && bone.norm() == 0; ++c)
            if (clip.skeleton.joint(c).parent == j)
                bone = clip.skeleton.joint(c).offset_m;
        if (bone.norm() == 0)
            bone = clip.skeleton.joint(j).end_m.value_or(axis);
        frames.push_back(smallestRotation(axis, bone) * axisAngle(axis, twist_rad(j)));
    }
    MotionClip made = reframed(clip, frames);
    if (keeps_tips)
        return made;
    std::vector<Joint> joints = made.skeleton.joints();
    for (Joint& joint : joints)
        if (joint.end_m)
            joint.end_m = Vector3d::Zero();
    made.skeleton = Skeleton::make(std::move(joints)).value();
    return made;
}

inline MotionClip renamed(const MotionClip& clip, const std::map<std::string, std::string>& names) {
    MotionClip made = clip;
    std::vector<Joint> joints = clip.skeleton.joints();
    for (Joint& joint : joints)
        if (const auto found = names.find(joint.name); found != names.end())
            joint.name = found->second;
    made.skeleton = Skeleton::make(std::move(joints)).value();
    return made;
}

inline MotionClip turnedInWorld(const MotionClip& clip, const Quaterniond& q) {
    MotionClip made = clip;
    for (Pose& pose : made.frames) {
        pose.p_world_root = q * pose.p_world_root;
        pose.q_parent_joint[0] = q * pose.q_parent_joint[0];
    }
    return made;
}

/// Position channels on every joint that hold what the OFFSETs should; these hold something else.
inline MotionClip withPositionChannels(const MotionClip& clip) {
    MotionClip made = clip;
    std::vector<Joint> joints = clip.skeleton.joints();
    std::vector<Vector3d> places;
    for (Joint& joint : joints) {
        places.push_back(joint.offset_m);
        joint.offset_m = joint.parent < 0 ? joint.offset_m : Vector3d(0.01, 0.02, 0.03);
    }
    made.skeleton = Skeleton::make(std::move(joints)).value();
    made.p_parent_joint_m.assign(made.frames.size(), places);
    return made;
}

inline UnderstoodMotion understood(const MotionClip& clip, double metres_per_unit = 0.01,
                                   const MotionHints& hints = {}) {
    BvhOptions options;
    options.metres_per_unit = metres_per_unit;
    Result<UnderstoodMotion> motion = understandMotion(toDocument(clip, options).value(), hints);
    EXPECT_TRUE(motion) << (motion ? "" : motion.error().text());
    return motion ? std::move(motion).value() : UnderstoodMotion{};
}

/// What a simulated take would hold: world poses of the actor.
struct Performed {
    Actor actor;
    std::vector<GlobalPose> poses;
};

inline Performed perform(const UnderstoodMotion& motion) {
    Performed performed;
    Result<Actor> actor = simulation::actorFromClip(motion.clip, motion.joints);
    EXPECT_TRUE(actor) << (actor ? "" : actor.error().text());
    if (!actor)
        return performed;
    performed.actor = *actor;
    const auto fitted =
        simulation::fitMotion(motion.clip, {performed.actor, performed.actor.skeleton, 7, motion.joints});
    EXPECT_TRUE(fitted) << (fitted ? "" : fitted.error().text());
    const simulation::Coordinates coordinates(performed.actor.skeleton);
    for (const auto& row : fitted->rows)
        performed.poses.push_back(globalPose(performed.actor.skeleton, coordinates.toPose(row)));
    return performed;
}

struct Difference {
    double mean_deg = 0;  ///< between bone directions, over bones and frames
    std::map<std::string, double> bones_deg;
    double worst_deg = 0;  ///< the bone with the largest mean
    std::string worst;
};

inline Difference differenceOf(const Performed& a, const Performed& b) {
    Difference difference;
    const size_t frames = std::min(a.poses.size(), b.poses.size());
    const auto bone = [](const Performed& who, size_t f, int j, bool tip) {
        const Joint& joint = who.actor.skeleton.joint(j);
        const GlobalPose& pose = who.poses[f];
        const size_t n = static_cast<size_t>(j);
        return tip ? Vector3d(pose.q_world_joint[n] * *joint.end_m)
                   : Vector3d(pose.p_world_joint[n] - pose.p_world_joint[static_cast<size_t>(joint.parent)]);
    };
    for (int j = 0; j < a.actor.skeleton.size(); ++j)
        for (const bool tip : {false, true}) {
            const Joint& joint = a.actor.skeleton.joint(j);
            if ((tip && !joint.end_m) || (!tip && joint.parent < 0))
                continue;
            double sum = 0;
            for (size_t f = 0; f < frames; ++f) {
                const Vector3d u = bone(a, f, j, tip), v = bone(b, f, j, tip);
                sum += degrees(std::atan2(u.cross(v).norm(), u.dot(v)));
            }
            difference.bones_deg[joint.name + (tip ? " tip" : "")] = sum / static_cast<double>(frames);
        }
    for (const auto& [name, deg] : difference.bones_deg) {
        difference.mean_deg += deg / static_cast<double>(difference.bones_deg.size());
        if (deg > difference.worst_deg) {
            difference.worst_deg = deg;
            difference.worst = name;
        }
    }
    return difference;
}

}  // namespace noctule::figure
