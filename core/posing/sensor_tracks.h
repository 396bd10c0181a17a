// SPDX-License-Identifier: Apache-2.0
// What a suit of independent inertial sensors has told, on one even grid of time: the attitude of each
// sensor by itself, with a heading that may be anything, and its readings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::posing {

/// How a sensor is turned on its segment by the suit's or the calibration's word.
struct StatedMounting {
    Quaterniond q_segment_sensor = Quaterniond::Identity();
    double sigma_rad = 0;
};

struct SensorTrack {
    std::string id;
    std::string segment;                     ///< canonical joint
    std::optional<StatedMounting> mounting;  ///< none: it sits anyhow
    // One entry per instant each; NaN: missing.
    std::vector<Quaterniond> q_world_sensor;
    std::vector<Vector3d> rate_rad_per_s;  ///< sensor's frame
    std::vector<Vector3d> accel_m_per_s2;  ///< specific force, sensor's frame
    /// Standard deviation of the heading against one north for all sensors; pi: there is no magnetometer.
    std::vector<double> heading_sigma_rad;

    bool has(size_t i) const { return q_world_sensor[i].coeffs().allFinite(); }
};

struct SensorTracks {
    double rate_hz = 0;
    int64_t first_ns = 0;
    std::vector<SensorTrack> sensors;

    size_t size() const { return sensors.empty() ? 0 : sensors.front().q_world_sensor.size(); }
};

/// Sensors on neighbouring segments: the nearest one above with a sensor, and the one below.
struct SensorPair {
    size_t above = 0, below = 0;
};

}  // namespace noctule::posing
