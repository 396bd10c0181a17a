// SPDX-License-Identifier: Apache-2.0
// Temperature and humidity of a take's place, and what the box's instruments say about them.
#pragma once

#include "core/simulation/random.h"
#include "core/simulation/scenario.h"

namespace noctule::simulation {

struct Air {
    double temperature_c = 22, humidity_percent = 50;
    double thermometer_error_c = 0;       ///< constant
    double speedOfSound_m_per_s() const;  ///< Cramer 1993, of the true air
};

Air drawAir(const Scenario& scenario, uint64_t seed);

/// The box's instruments, read once a second.
class AirInstruments {
public:
    AirInstruments(const Air& air, const Scenario& scenario, uint64_t seed);
    struct Values {
        double temperature_c, humidity_percent;
    };
    Values read();

private:
    Air air_;
    double temperature_noise_c_, humidity_noise_percent_;
    Random random_;
};

}  // namespace noctule::simulation
