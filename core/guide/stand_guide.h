// SPDX-License-Identifier: Apache-2.0
// Guide of what a performer does standing still in the rest pose: one step. Nobody stands as still as a board
// on a table lies.
#pragma once

#include "core/guide/guide.h"

namespace noctule {

class StandGuide : public Guide {
public:
    /// Breathing and sway; a step or a raised arm is ten times that.
    static constexpr double kSway_rad_per_s = 0.1, kSway_m_per_s2 = 0.5;

    StandGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz)
        : Guide(suit, calibration, sample_rate_hz, 1) {}

    static bool isCalm(const BoardHealth::Means& means) {
        return means.gyro_deviation_rad_per_s < kSway_rad_per_s &&
               means.accel_deviation_m_per_s2 < kSway_m_per_s2;
    }

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;
};

}  // namespace noctule
