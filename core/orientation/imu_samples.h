// SPDX-License-Identifier: Apache-2.0
// Readings of one inertial sensor, calibrated, in the sensor's own frame.
#pragma once

#include <vector>

#include "core/math/conventions.h"

namespace noctule {

/// A missing reading is NaN.
struct ImuSamples {
    double rate_hz = 0;  ///< usual
    std::vector<Vector3d> gyro_rad_per_s;
    std::vector<Vector3d> accel_m_per_s2;  ///< specific force: at rest it points up
    /// Any unit; the Earth's field has about 50 uT. Empty: the sensor has no magnetometer.
    std::vector<Vector3d> mag;
    /// Time from the row before to each row. Empty: the rate is constant, 1/rate_hz.
    std::vector<double> step_s;

    /// A longer step is a pause: the sensor told nothing for most of it. Twice the step of 10 Hz.
    static constexpr double kLongestStep_s = 0.2;

    size_t size() const { return gyro_rad_per_s.size(); }
    bool hasMag(size_t i) const { return i < mag.size() && mag[i].allFinite() && !mag[i].isZero(); }
    /// Time that reading `i` stands for.
    double interval_s(size_t i) const {
        return i < step_s.size() && step_s[i] <= kLongestStep_s ? step_s[i] : 1 / rate_hz;
    }
    /// Time without readings before that; 0: none.
    double pause_s(size_t i) const { return i < step_s.size() ? step_s[i] - interval_s(i) : 0; }
    /// The rate of turn that the gyroscope would most likely have read in the pause before row `i`: the mean
    /// of the readings before and after, each over the length of the pause, 1 s at most.
    Vector3d rateInPause_rad_per_s(size_t i) const;
};

}  // namespace noctule
