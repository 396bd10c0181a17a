// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/air.h"

#include <algorithm>

#include "core/acoustics/speed_of_sound.h"

namespace noctule::simulation {

double Air::speedOfSound_m_per_s() const {
    return speedOfSoundCramer(temperature_c, humidity_percent);
}

Air drawAir(const Scenario& scenario, uint64_t seed) {
    Random random(seed, "air");
    Air air;
    air.temperature_c = random.uniform(scenario.temperature_c[0], scenario.temperature_c[1]);
    air.humidity_percent = random.uniform(scenario.humidity_percent[0], scenario.humidity_percent[1]);
    air.thermometer_error_c = Random(seed, "thermometer").gaussian(scenario.temperature_error_c);
    return air;
}

AirInstruments::AirInstruments(const Air& air, const Scenario& scenario, uint64_t seed)
    : air_(air),
      temperature_noise_c_(scenario.temperature_noise_c),
      humidity_noise_percent_(scenario.humidity_noise_percent),
      random_(seed, "air instruments") {}

AirInstruments::Values AirInstruments::read() {
    const double temperature_c =
        air_.temperature_c + air_.thermometer_error_c + random_.gaussian(temperature_noise_c_);
    const double humidity = air_.humidity_percent + random_.gaussian(humidity_noise_percent_);
    return {temperature_c, std::clamp(humidity, 0.0, 100.0)};
}

}  // namespace noctule::simulation
