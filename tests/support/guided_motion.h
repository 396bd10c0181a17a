// SPDX-License-Identifier: Apache-2.0
// The guided movement that a calibration from motion asks for, as a performer may do it: squats with elbow
// and wrist bends, arm circles with leg swings, turns and bends of trunk, head and shoulders; 13 s each, from
// the rest pose.
#pragma once

#include <cmath>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/motion/clip.h"

namespace noctule::test {

class GuidedMotion {
public:
    /// `vigour` scales all angles.
    static MotionClip clip(double seconds = 39, double vigour = 1) {
        GuidedMotion motion;
        motion.part_s_ = seconds / 3;
        MotionClip clip;
        clip.name = "guided motion";
        clip.skeleton = motion.actor_.skeleton;
        for (int f = 0; f < static_cast<int>(std::lround(seconds * 120)); ++f)
            clip.frames.push_back(motion.pose(f / 120.0, vigour));
        return clip;
    }

private:
    /// 0..1..0 over one part.
    double share(int part, double t) const {
        const double begin = part * part_s_, end = begin + part_s_;
        const auto rise = [](double x) {
            const double u = std::clamp(x / 1.5, 0.0, 1.0);
            return u * u * (3 - 2 * u);
        };
        return rise(t - begin + 0.3) * rise(end + 0.3 - t);
    }
    static double wave(double hz, double t, double phase = 0) {
        return std::sin(2 * std::numbers::pi * hz * t + phase);
    }
    /// 0 to 1 and back.
    static double bend(double hz, double t, double phase = 0) { return (1 - wave(hz, t, phase)) / 2; }

    Pose pose(double t, double vigour) const {
        Pose pose = actor_.restPose();
        const double squat = 1.1 * vigour * share(0, t) * bend(0.5, t);
        const double kick_l = vigour * share(1, t) * wave(0.55, t);
        const double kick_r = vigour * share(1, t) * wave(0.55, t, 2.6);
        const double trunk = vigour * share(2, t);
        const auto set = [&](const char* joint, const Quaterniond& q) {
            pose.q_parent_joint[static_cast<size_t>(actor_.skeleton.find(joint))] = q;
        };
        const auto about = [](double x, double y, double z) { return expQuaternion(Vector3d(x, y, z)); };
        pose.q_parent_joint[0] = about(0.35 * squat + 0.15 * trunk * wave(0.4, t), 0.5 * trunk * wave(0.3, t),
                                       0.15 * trunk * wave(0.37, t, 1));
        pose.p_world_root.y() -= 0.43 * (1 - std::cos(0.8 * squat)) * 1.6;
        set("Spine", about(0.1 * squat + 0.3 * trunk * wave(0.45, t), 0.25 * trunk * wave(0.53, t, 1),
                           0.3 * trunk * wave(0.61, t, 2)));
        set("Chest", about(0.15 * squat + 0.3 * trunk * wave(0.55, t, 2), 0.35 * trunk * wave(0.43, t),
                           0.3 * trunk * wave(0.5, t, 1)));
        set("Head",
            about(0.5 * trunk * wave(0.6, t), 0.8 * trunk * wave(0.45, t, 1), 0.3 * trunk * wave(0.7, t)));
        for (const double side : {1.0, -1.0})
            poseLimbs(side, squat, side > 0 ? kick_l : kick_r, t, vigour, pose);
        return pose;
    }

    void poseLimbs(double side, double squat, double kick, double t, double vigour, Pose& pose) const {
        const std::string name = side > 0 ? "Left" : "Right";
        const auto joint = [&](const char* of) -> Quaterniond& {
            return pose.q_parent_joint[static_cast<size_t>(actor_.skeleton.find(name + of))];
        };
        const auto about = [](double x, double y, double z) { return expQuaternion(Vector3d(x, y, z)); };
        const double phase = side > 0 ? 0 : 0.7;
        const double hands = vigour * share(0, t), circle = vigour * share(1, t),
                     trunk = vigour * share(2, t);
        joint("UpLeg") = about(-1.25 * squat - 0.5 * kick, side * (0.2 * squat + 0.3 * kick),
                               side * (0.15 * squat + 0.25 * std::abs(circle) * bend(0.43, t, phase)));
        joint("Leg") = about(1.8 * squat + 0.9 * circle * bend(0.6, t, phase), 0, 0);
        joint("Foot") = axisAngle(Vector3d::UnitZ(), 0.3 * circle * wave(0.7, t, phase)) *
                        axisAngle(Vector3d::UnitX(), -0.5 * squat + 0.4 * circle * wave(0.8, t, phase));
        joint("Shoulder") =
            axisAngle(Vector3d::UnitZ(), side * 0.25 * (trunk * bend(0.5, t, phase) + 0.5 * circle)) *
            axisAngle(Vector3d::UnitY(), 0.25 * trunk * wave(0.6, t, phase));
        joint("Arm") = about(-(0.5 * hands + 0.8 * circle + 0.6 * trunk) + 0.6 * circle * wave(0.6, t, phase),
                             -side * 0.4 * trunk * wave(0.5, t, phase), 0) *
                       about(0, 0, side * (0.6 * circle * wave(0.6, t, phase + 1.57) + 0.6 * circle)) *
                       joint("Arm") * about(0.5 * (circle + hands) * wave(0.47, t, phase), 0, 0);
        joint("ForeArm") = axisAngle(-side * Vector3d::UnitY(), 0.5 + 1.3 * hands * bend(0.7, t, phase) +
                                                                    0.5 * trunk * bend(0.6, t, phase)) *
                           axisAngle(Vector3d::UnitX(), 0.8 * hands * wave(0.5, t, phase + 1) +
                                                            0.5 * trunk * wave(0.6, t, phase));
        joint("Hand") = axisAngle(Vector3d::UnitZ(), 0.35 * (hands + trunk) * wave(0.8, t, phase)) *
                        axisAngle(Vector3d::UnitY(), 0.6 * (hands + trunk) * wave(0.65, t, phase + 1));
    }

    Actor actor_ = defaultActor();
    double part_s_ = 13;
};

}  // namespace noctule::test
