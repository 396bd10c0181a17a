// SPDX-License-Identifier: Apache-2.0
// Headings that agree: the turn about the vertical that takes each sensor's own world to one that all share.
// Two sensors on neighbouring segments see the acceleration of their joint; its horizontal part tells how
// their headings differ, whatever the joint's kind and without a magnetometer (Weygers, Kok, "Drift-free
// inertial sensor-based joint kinematics for long-term arbitrary movements", IEEE Sensors Journal 20, 2020).
// All such measurements, drift and magnetometers make one least-squares problem over the whole recording.
#pragma once

#include "core/job/job.h"
#include "core/posing/sensor_tracks.h"

namespace noctule::posing {

/// Standard deviations; none is fitted to a recording.
struct HeadingSettings {
    double knot_s = 2;                   ///< headings are straight lines between knots
    double drift_rad_per_s = 0.0015;     ///< constant drift of each sensor
    double walk_rad_per_sqrt_s = 0.004;  ///< random walk beside it
    double gap_rad_per_s = 0.3;          ///< per second without readings
    double accel_m_per_s2 = 0.15;        ///< least error of a joint's acceleration
    double least_pair_rad = 0.05;        ///< a window tells no more than that
    double correlated_rows = 8;          ///< errors of so many rows in a row are alike (soft tissue)
    double field_rad = 0.15;             ///< least error of a magnetometer's heading that lasts
    double huber_sigma = 1.5;
};

struct Headings {
    // Per sensor and instant; add to the heading of q_world_sensor (a turn about Y).
    std::vector<std::vector<double>> heading_rad;
    std::vector<std::vector<double>> sigma_rad;  ///< against the first sensor; up to pi
    std::optional<double> facing_rad;            ///< of the body while it stands; none: no heading is stated
    std::vector<std::string> warnings;           ///< whole sentences

    Quaterniond turned(const SensorTracks& tracks, size_t sensor, size_t i) const;
};

/// A sensor's heading while the body stands and faces Z, from its stated mounting and a marked rest pose.
struct StatedHeading {
    double heading_rad = 0, sigma_rad = 0;
};
struct StandingHeadings {
    size_t instant = 0;                                   ///< at which the body stands
    std::vector<std::optional<StatedHeading>> of_sensor;  ///< none: it must come from the movement
};

/// The first sensor keeps its heading at the instant of standing. Errors: kCancelled alone.
Result<Headings> agreeHeadings(const SensorTracks& tracks, const std::vector<SensorPair>& pairs,
                               const StandingHeadings& standing, const HeadingSettings& settings,
                               const JobContext& job);

}  // namespace noctule::posing
