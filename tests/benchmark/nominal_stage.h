// SPDX-License-Identifier: Apache-2.0
// The default suit on a recorded motion, scenario nominal: what most figures are measured on.
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

}  // namespace noctule
