// SPDX-License-Identifier: Apache-2.0
// From the attitudes of independent sensors to the body's pose: README.md has the steps and their sources.
#pragma once

#include "core/body/actor.h"
#include "core/job/job.h"
#include "core/motion/timed_poses.h"
#include "core/posing/headings.h"
#include "core/posing/pose_fit.h"
#include "core/posing/standing.h"

namespace noctule::posing {

struct PosingSettings {
    HeadingSettings headings;
    PoseFitSettings fit;
    double join_s = 0.5;  ///< a sensor that comes back counts fully after so long
};

struct BodyMotion {
    std::vector<TimedPose> poses;  ///< one per instant of the tracks; faces Z while it stands
    Standing standing;
    std::vector<std::string> warnings;  ///< whole sentences
};

/// `rest`: instants in which the actor's rest pose is held, when the take marks them. kUnusable: no sensor
/// on a segment of the actor, or too short a recording.
Result<BodyMotion> poseBody(const Actor& actor, const SensorTracks& tracks,
                            const std::optional<std::pair<size_t, size_t>>& rest,
                            const PosingSettings& settings, const JobContext& job);

}  // namespace noctule::posing
