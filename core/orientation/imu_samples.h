// SPDX-License-Identifier: Apache-2.0
// Readings of one inertial sensor at a constant rate, calibrated, in the sensor's own frame.
#pragma once

#include <vector>

#include "core/math/conventions.h"

namespace noctule {

/// Rows are instants 1/rate_hz apart. A missing reading is NaN.
struct ImuSamples {
    double rate_hz = 0;
    std::vector<Vector3d> gyro_rad_per_s;
    std::vector<Vector3d> accel_m_per_s2;  ///< specific force: at rest it points up
    /// Any unit; the Earth's field has about 50 uT. Empty: the sensor has no magnetometer.
    std::vector<Vector3d> mag;

    size_t size() const { return gyro_rad_per_s.size(); }
    bool hasMag(size_t i) const { return i < mag.size() && mag[i].allFinite() && !mag[i].isZero(); }
};

}  // namespace noctule
