// SPDX-License-Identifier: Apache-2.0
// Bodies for the simulation's tests: a made motion of the default actor, and the motions that
// assimp-testmodels installs.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "core/body/actor.h"
#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/simulation/body_world.h"
#include "core/suit/default_suit.h"

namespace noctule::simulation {

/// A file-like clip of the default actor's figure: every joint swings at its own pace, the root walks a bend.
inline MotionClip madeMotion(double seconds = 4) {
    MotionClip clip;
    clip.name = "made motion";
    clip.skeleton = freedActor(defaultActor()).skeleton;
    for (int f = 0; f < static_cast<int>(std::lround(seconds * 120)); ++f) {
        const double t = f / 120.0;
        Pose pose = clip.skeleton.zeroPose();
        pose.p_world_root = {0.4 * std::sin(0.7 * t), 0.97 + 0.03 * std::sin(9 * t), 0.8 * t};
        pose.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), 0.6 + 0.5 * std::sin(t));
        for (int j = 1; j < clip.skeleton.size(); ++j) {
            const std::string& name = clip.skeleton.joint(j).name;
            const double swing = std::sin((2 + 0.3 * j) * t + j);
            if (name.ends_with("ForeArm"))
                pose.q_parent_joint[j] =
                    axisAngle((name.starts_with("Left") ? -1 : 1) * Vector3d::UnitY(), 0.9 + 0.6 * swing);
            else if (name.ends_with("Leg") && !name.ends_with("UpLeg"))
                pose.q_parent_joint[j] = axisAngle(Vector3d::UnitX(), 0.7 + 0.5 * swing);
            else if (name.ends_with("Arm") || name.ends_with("UpLeg") || name == "Spine" || name == "Head")
                pose.q_parent_joint[j] = expQuaternion(0.3 * swing * Vector3d(1, 0.5, -0.7));
        }
        clip.frames.push_back(pose);
    }
    return clip;
}

/// Whole chain from a clip to a world, reduced to the default actor's freedoms.
inline BodyWorld makeWorld(const MotionClip& clip, const Scenario& scenario, const Timing& timing = {},
                           uint64_t seed = 1) {
    const Actor actor = actorFromClip(clip).value();
    const Actor mover = scenario.unreduced_motion ? freedActor(actor) : actor;
    const FittedMotion motion = fitMotion(clip, {actor, mover.skeleton, scenario.motion_low_pass_hz}).value();
    const Coordinates coordinates(mover.skeleton);
    const std::vector<double> rest = heldRestRow(coordinates, mover, scenario, seed);
    return BodyWorld(Performance(coordinates, rest, &motion, timing),
                     wear(defaultSuit(), mover.skeleton, scenario, seed).value(), mover.capsules,
                     scenario.soft_tissue);
}

/// One of the motions of Debian's assimp-testmodels, or an empty path when the package is absent.
inline std::string installedMotion(const std::string& name) {
    const std::string path = "/usr/share/assimp/models/BVH/" + name;
    return std::filesystem::exists(path) ? path : "";
}

}  // namespace noctule::simulation
