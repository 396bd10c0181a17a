// SPDX-License-Identifier: Apache-2.0
// What several suits in one room add to a scenario: the clocks of their boxes, how well anchors are surveyed
// and how well a transceiver's housing is known. Bounds are those of a uniform draw, sigmas are Gaussian. The
// defaults are `ideal`.
#pragma once

#include "core/simulation/sound_scenario.h"

namespace noctule::simulation {

struct CastScenario {
    Bounds clock_offset_s{-0.02, 0.02};  ///< of a box against take time
    Bounds clock_rate_error{0, 0};       ///< relative, constant in a take
    double clock_wander_s_per_sqrt_s = 0, clock_rate_wander_per_sqrt_s = 0;
    Bounds first_guess_error_s{-0.005, 0.005};  ///< of the recorder, by its network's time
    double survey_m = 0;                        ///< of an anchor's place, per axis and housing
    double housing_m = 0;  ///< of a transceiver's source against its microphone, per axis
};

/// The room of a cast: the middle of its floor is the world's origin.
struct ChamberScenario {
    double width_m = 5, depth_m = 5, height_m = 2.8;
    double floor_gain_db = -5, ceiling_gain_db = -8;  ///< walls: SoundScenario::wall_gain_db
};

/// Sound that leaves on a carrier fades by this much, dB per metre; `at_40_khz`: the scenario's.
inline double absorptionAt(double carrier_hz, double at_40_khz) {
    return at_40_khz * std::pow(carrier_hz / 40000, 1.2);
}

}  // namespace noctule::simulation
