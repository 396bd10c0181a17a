// SPDX-License-Identifier: Apache-2.0
// The default suit on a recorded motion, scenario nominal: what most figures are measured on, and its take.
#pragma once

#include "core/formats/bvh.h"
#include "core/simulation/simulate.h"
#include "core/suit/default_suit.h"

namespace noctule {

/// Of a BVH file; the whole of what it makes lasts `seconds`.
inline simulation::StageRequest nominalStage(const std::string& motion, double seconds) {
    simulation::StageRequest request;
    request.clip = toClip(readBvh(motion).value()).value();
    request.suit = defaultSuit();
    request.scenario = simulation::Scenario::nominal();
    request.duration_s = seconds;
    return request;
}

/// As a take of readings and ranges, in place of one that is there.
inline void writeReadings(const simulation::Stage& stage, const std::string& path) {
    simulation::TakeRequest take;
    take.out_path = path;
    take.level = simulation::Level::kReadings;
    take.overwrite = true;
    take.created_utc = "2000-01-01T00:00:00Z";
    simulation::writeTake(stage, take, {}).value();
}

}  // namespace noctule
