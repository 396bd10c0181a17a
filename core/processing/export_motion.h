// SPDX-License-Identifier: Apache-2.0
// The motion that a request takes out of its take: cut, resampled and its root held as wanted.
#pragma once

#include <string>
#include <vector>

#include "core/mesh/foot_lock.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"
#include "core/processing/export_take.h"

namespace noctule {

struct ExportedMotion {
    std::string run;
    MotionClip clip;
    std::vector<std::vector<float>> confidence;  ///< per frame and joint; empty: not known
    StandingFeet feet;                           ///< of the clip; none when they stay free
    MotionClip filmed;                           ///< at the film's rate; empty without pictures
    StandingFeet filmed_feet;
};

/// Whether feet of its body keep their place.
bool locksFeet(const ExportRequest& request);
/// When feet stand, in seconds from `begin_s` of the take's clock; what overlaps is one stand.
FootPlants footPlants(const std::vector<FootContacts>& feet, double begin_s);

/// kUnusable without a pose in the wanted part; errors of opening the take are passed on.
Result<ExportedMotion> exportedMotion(const ExportRequest& request);

}  // namespace noctule
