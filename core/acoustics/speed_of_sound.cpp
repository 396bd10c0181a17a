// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/speed_of_sound.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

using Series = std::vector<std::pair<int64_t, double>>;

void insert(Series& series, int64_t sample, std::optional<double> value, double min, double max) {
    if (!value || !(*value >= min && *value <= max))
        return;
    const std::pair point(sample, *value);
    series.insert(std::upper_bound(series.begin(), series.end(), point), point);
}

double interpolate(const Series& series, int64_t sample, double if_empty) {
    if (series.empty())
        return if_empty;
    const auto next = std::partition_point(series.begin(), series.end(),
                                           [sample](const auto& point) { return point.first <= sample; });
    if (next == series.begin())
        return next->second;
    const auto previous = next - 1;
    if (next == series.end())
        return previous->second;
    const double fraction = double(sample - previous->first) / double(next->first - previous->first);
    return previous->second + fraction * (next->second - previous->second);
}

}  // namespace

double speedOfSoundCramer(double temperature_c, double humidity_percent) {
    constexpr double p = 101325, x_c = 0.0004;  // Pa, mole fraction of CO2
    const double t = temperature_c, T = t + 273.15;
    const double p_sv =
        std::exp(1.2811805e-5 * T * T - 1.9509874e-2 * T + 34.04926034 - 6353.6311 / T);  // saturated vapour
    const double f = 1.00062 + 3.14e-8 * p + 5.6e-7 * t * t;  // enhancement factor
    const double x = humidity_percent / 100 * f * p_sv / p;   // mole fraction of water vapour
    return 331.5024 + 0.603055 * t - 0.000528 * t * t + (51.471935 + 0.1495874 * t - 0.000782 * t * t) * x +
           (-1.82e-7 + 3.73e-8 * t - 2.93e-10 * t * t) * p +
           (-85.20931 - 0.228525 * t + 5.91e-5 * t * t) * x_c - 2.835149 * x * x - 2.15e-13 * p * p +
           29.179762 * x_c * x_c + 0.000486 * x * p * x_c;
}

double speedOfSoundLinear(double temperature_c, double humidity_percent) {
    return 331.3 + 0.606 * temperature_c + 0.0124 * humidity_percent;
}

SpeedOfSound::SpeedOfSound(const SoundModel& model, std::span<const TemperatureStatus> rows) : model_(model) {
    for (const TemperatureStatus& row : rows)
        add(row);
}

void SpeedOfSound::add(const TemperatureStatus& row) {
    insert(temperature_c_, row.sample, row.temperature_c, -60, 70);
    insert(humidity_percent_, row.sample, row.humidity_percent, 0, 100);
}

double SpeedOfSound::at(int64_t sample) const {
    const double t = interpolate(temperature_c_, sample, kAssumedTemperature_c);
    const double humidity = interpolate(humidity_percent_, sample, kAssumedHumidity_percent);
    switch (model_.kind) {
        case SoundModel::Kind::kCramer:
            return model_.scale * speedOfSoundCramer(t, humidity);
        case SoundModel::Kind::kLinear:
            return model_.scale * speedOfSoundLinear(t, humidity);
        case SoundModel::Kind::kFixed:
            break;
    }
    return model_.scale * model_.c_m_per_s;
}

bool SpeedOfSound::temperatureAssumed() const {
    return model_.kind != SoundModel::Kind::kFixed && temperature_c_.empty();
}

}  // namespace noctule
