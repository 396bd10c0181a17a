// SPDX-License-Identifier: Apache-2.0
// Smooth motions with known properties for the tests of this room.
#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/motion/comparison.h"

namespace noctule::test {

inline Skeleton skeleton() {
    return defaultActor().skeleton;
}

constexpr int64_t kSecond_ns = 1'000'000'000;

/// Every moving joint swings about an axis of its own with a rhythm of its own, never repeating within a
/// minute.
inline Pose swingingPose(const Skeleton& skeleton, double t_s) {
    Pose pose = skeleton.zeroPose();
    pose.p_world_root = {0.5 * std::sin(0.4 * t_s), 1, 0.3 * t_s};
    pose.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), 0.6 * std::sin(0.5 * t_s));
    for (int j = 1; j < skeleton.size(); ++j) {
        if (skeleton.joint(j).type == JointType::kFixed)
            continue;
        const Vector3d axis = Vector3d(1 + j % 3, j % 5, 2 - j % 2).normalized();
        const double angle = 0.5 * std::sin((1 + 0.137 * j) * t_s + j) + 0.2 * std::sin(0.31 * t_s * t_s);
        pose.q_parent_joint[static_cast<size_t>(j)] = axisAngle(axis, angle);
    }
    return pose;
}

inline TimedMotion swinging(const Skeleton& skeleton, double seconds, double frames_per_second,
                            double late_s = 0) {
    TimedMotion motion{skeleton, {}};
    for (int i = 0; i < seconds * frames_per_second; ++i) {
        const double t_s = i / frames_per_second;
        motion.frames.push_back({std::llround(t_s * 1e9), swingingPose(skeleton, t_s - late_s), {}});
    }
    return motion;
}

/// Multiplies one joint's rotation on the right by what `error` gives for each time.
inline void disturb(TimedMotion& motion, const std::string& joint,
                    const std::function<Quaterniond(double t_s)>& error) {
    const auto j = static_cast<size_t>(motion.skeleton.find(joint));
    for (TimedPose& frame : motion.frames)
        frame.pose->q_parent_joint[j] =
            frame.pose->q_parent_joint[j] * error(static_cast<double>(frame.time_ns) * 1e-9);
}

}  // namespace noctule::test
