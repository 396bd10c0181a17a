// SPDX-License-Identifier: Apache-2.0
// The motion that a request takes out of its take: cut, resampled and its root held as wanted.
#pragma once

#include <string>
#include <vector>

#include "core/mesh/retarget/foot_lock.h"
#include "core/motion/timed_poses.h"
#include "core/processing/export_take.h"
#include "core/processing/standing_feet.h"

namespace noctule {

struct ExportedMotion {
    std::string run;
    MotionClip clip;
    double begin_s = 0;                          ///< of its first frame, on the take's clock
    std::vector<std::string> held;               ///< whole sentences: where it stands still
    std::vector<std::vector<float>> confidence;  ///< per frame and joint; empty: not known
    StandingFeet feet;                           ///< of the clip; none when they stay free
    MotionClip filmed;                           ///< at the film's rate; empty without pictures
    StandingFeet filmed_feet;
    FeetAtRest feet_at_rest;  ///< as the whole take shows them
};

/// Whether feet of its body keep their place.
bool locksFeet(const ExportRequest& request);

/// kUnusable without a pose in the wanted part; errors of opening the take are passed on.
Result<ExportedMotion> exportedMotion(const ExportRequest& request);

}  // namespace noctule
