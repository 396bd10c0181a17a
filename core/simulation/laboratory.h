// SPDX-License-Identifier: Apache-2.0
// All that one take hides, drawn once from its seed, and the calibration that a good laboratory would have
// made of this suit: exact but for the scenario's errors.
#pragma once

#include <nlohmann/json.hpp>

#include "core/simulation/air.h"
#include "core/simulation/inertial_sensor.h"
#include "core/simulation/worn_suit.h"

namespace noctule::simulation {

struct HiddenTruth {
    uint64_t seed = 0;
    Air air;
    SoundTruth sound;
    std::vector<double> inflection_offset_s;  ///< per source, at distance 0
    std::vector<InertialTruth> inertia;       ///< per board
};

HiddenTruth drawHiddenTruth(const Suit& suit, const Scenario& scenario, uint64_t seed);

Calibration laboratoryCalibration(const Suit& suit, const Scenario& scenario, const HiddenTruth& truth);

/// Every hidden value of suit and air, named as in scenarios.json and in the calibration JSON.
nlohmann::json toJson(const HiddenTruth& truth, const Suit& suit, const Scenario& scenario);
/// Where boards and sources really sit.
void addWorn(nlohmann::json& truth, const WornSuit& worn);

}  // namespace noctule::simulation
