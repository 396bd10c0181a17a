// SPDX-License-Identifier: Apache-2.0
#include "core/import/sensor_findings.h"

#include <algorithm>

namespace noctule {

namespace {

bool holdsAny(const std::vector<Vector3d>& readings) {
    return std::any_of(readings.begin(), readings.end(),
                       [](const Vector3d& reading) { return reading.allFinite(); });
}

}  // namespace

SensorFindings findingsOf(const ImportedSensor& sensor) {
    const ImuSamples& samples = sensor.samples;
    SensorFindings found;
    found.gyroscope = holdsAny(samples.gyro_rad_per_s);
    found.accelerometer = holdsAny(samples.accel_m_per_s2);
    found.magnetometer = holdsAny(samples.mag);
    found.attitude = !sensor.q_world_sensor.empty();
    found.rows = samples.size();
    found.duration_s = double(samples.size()) / samples.rate_hz;
    for (size_t i = 0; i < samples.size(); ++i)
        found.missing +=
            !samples.gyro_rad_per_s[i].allFinite() && !samples.accel_m_per_s2[i].allFinite() &&
            (i >= sensor.q_world_sensor.size() || !sensor.q_world_sensor[i].coeffs().allFinite());
    return found;
}

}  // namespace noctule
