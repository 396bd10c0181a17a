// SPDX-License-Identifier: Apache-2.0
#include "core/live/levels.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr double kMiddle_counts = 2048;  ///< of a reading; also its full scale

}  // namespace

double level_db(double amplitude, double full_scale) {
    return amplitude > 0 ? std::max(kSilence_db, 20 * std::log10(amplitude / full_scale)) : kSilence_db;
}

std::optional<double> motionLevel_db(const InertialReading& reading) {
    double power = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        const std::optional<double>& counts = reading.counts[axis];
        if (!counts)
            return std::nullopt;
        power += (*counts - kMiddle_counts) * (*counts - kMiddle_counts);
    }
    return std::min(0.0, level_db(std::sqrt(power), kMiddle_counts));
}

void MeterNeedle::show(double level_db, double t_s) {
    const double fallen_db = kFall_db_per_s * std::max(0.0, t_s - t_s_);
    const double held_until_s = peak_since_s_ + kHold_s;
    // Only the time after the hold counts for the fall of the peak.
    const double peak_fallen_db = kFall_db_per_s * std::max(0.0, t_s - std::max(t_s_, held_until_s));
    t_s_ = std::max(t_s_, t_s);
    level_ = std::max({level_db, level_ - fallen_db, kSilence_db});
    peak_ = std::max(peak_ - peak_fallen_db, kSilence_db);
    if (level_ >= peak_) {
        peak_ = level_;
        peak_since_s_ = t_s_;
    }
}

}  // namespace noctule
