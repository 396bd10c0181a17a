// SPDX-License-Identifier: Apache-2.0
// Speed of sound in m/s over a take, from the sound model in force and the box's thermometer and hygrometer.
// Between status rows both are interpolated linearly, the ends are held (core/recording/README.md, section
// 5).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/suit/calibration.h"

namespace noctule {

/// Cramer 1993 ("The variation of the specific heat ratio and the speed of sound in air ...", J. Acoust. Soc.
/// Am. 93, 2510), at 101 325 Pa and 0.04 % carbon dioxide. Meant for 0..30 C; 345.4736287 m/s at 22.5 C and
/// 44.652861 %.
double speedOfSoundCramer(double temperature_c, double humidity_percent);

/// 331.3 + 0.606 T + 0.0124 RH: within 0.24 % of Cramer's from 0 to 30 C.
double speedOfSoundLinear(double temperature_c, double humidity_percent);

/// What the box said about the air at one sample of the suit's clock.
struct TemperatureStatus {
    int64_t sample = 0;
    std::optional<double> temperature_c;
    std::optional<double> humidity_percent;
};

class SpeedOfSound {
public:
    /// Held where nothing was ever measured. A wrong temperature costs 0.18 % of distance per kelvin.
    static constexpr double kAssumedTemperature_c = 20, kAssumedHumidity_percent = 50;

    explicit SpeedOfSound(const SoundModel& model, std::span<const TemperatureStatus> rows = {});

    /// Rows may come in any order. Values that no air on earth has (also NaN) are ignored.
    void add(const TemperatureStatus& row);

    double at(int64_t sample) const;

    /// The model needs a temperature and none was measured: kAssumedTemperature_c is used.
    bool temperatureAssumed() const;

private:
    using Series = std::vector<std::pair<int64_t, double>>;  // by sample

    SoundModel model_;
    Series temperature_c_, humidity_percent_;
};

}  // namespace noctule
