// SPDX-License-Identifier: Apache-2.0
// From any recorded motion to one that an actor's joints can make: cleaned, fitted to the joints' freedoms
// from the root to the leaves, low-passed without phase on angles and quaternions, standing on the floor,
// facing +Z at its first frame above the world's origin. This is the truth that a simulated take is scored
// against.
#pragma once

#include "core/body/actor.h"
#include "core/figure/joint_mapping.h"
#include "core/motion/clip.h"
#include "core/simulation/coordinates.h"

namespace noctule::simulation {

/// The default actor with the lengths of the clip's figure. `joints`: as the clip was understood; none: found
/// here. Fails (kUnusable) when joints cannot be mapped or the figure has no person's size.
Result<Actor> actorFromClip(const MotionClip& clip,
                            const std::optional<figure::JointMapping>& joints = std::nullopt);

/// The same joints, every one but the root a ball joint without limits: what flesh really does.
Actor freedActor(const Actor& actor);

/// How well the fitted motion follows the recorded one, before the low-pass.
struct FitQuality {
    std::string joint;
    double mean_rad = 0, max_rad = 0;  ///< geodesic angle between wanted and made world orientation
};

struct FittedMotion {
    double step_s = 0;
    std::vector<std::vector<double>> rows;  ///< of Coordinates(mover.skeleton)
    std::vector<FitQuality> quality;        ///< joints with freedom that the file has, the root excepted
    int repaired_frames = 0;                ///< single frames that jumped and were replaced
    bool dropped_first_frame = false;       ///< a calibration pose before the motion
    Vector3d start_m = Vector3d::Zero();    ///< where the file's figure stands in its first frame, y = 0
    double start_yaw_rad = 0;               ///< where its root faces then: 0 is +Z
};

struct FitRequest {
    const Actor& actor;     ///< whose joints say how limbs bend
    const Skeleton& mover;  ///< the joints that really move: the actor's or freedActor's
    double low_pass_hz = 7;
    std::optional<figure::JointMapping> joints{};  ///< as the clip was understood; none: found here
};

/// Fails (kUnusable) when joints cannot be mapped or a number is not finite (names frame and joint).
Result<FittedMotion> fitMotion(const MotionClip& clip, const FitRequest& request);

/// Lowest joint or tip of a pose, metres above the world's floor.
double lowestPoint(const Coordinates& coordinates, const std::vector<double>& row);

}  // namespace noctule::simulation
