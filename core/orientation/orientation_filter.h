// SPDX-License-Identifier: Apache-2.0
// Orientation of one inertial sensor: an error-state Kalman filter over attitude, velocity, place, biases and
// the magnetometer's time lag. A sensor stays in a room, so velocity and place are loosely held to zero;
// gravity is what remains of the accelerometer's reading. The magnetometer tells heading alone. World frame:
// field_reference.h. Source: error-state filter after Sola 2017, "Quaternion kinematics for the error-state
// Kalman filter" (global errors); pseudo-measurements of velocity and place as in pedestrian navigation.
#pragma once

#include "core/job/job.h"
#include "core/orientation/field_reference.h"

namespace noctule {

/// Standard deviations. All are of sensors in general; none is fitted to a recording.
struct OrientationSettings {
    bool smooth = false;  ///< Rauch-Tung-Striebel smoothing over the whole recording

    double step_s =
        0.05;  ///< covariance and corrections advance at this interval; readings are integrated each

    double gyro_noise_rad_per_sqrt_s = 2e-3;   ///< white noise of the rate
    double accel_noise_m_per_s_sqrt_s = 0.03;  ///< white noise of the acceleration, inflated
    double gyro_walk_rad_per_s_sqrt_s = 2e-5;  ///< random walk of the gyroscope's bias
    double accel_walk_m_per_s2_sqrt_s = 2e-4;  ///< random walk of the accelerometer's bias

    double velocity_m_per_s = 1;  ///< pseudo-measurement of zero velocity, once a second
    double place_m = 0.5;         ///< pseudo-measurement of the first place, once a second

    double mag_heading_rad = 0.1;   ///< one heading by the field; more where the field is not the Earth's
    double disturbance_rad = 0.06;  ///< heading error of the field that lasts; first-order Gauss-Markov
    double disturbance_s = 1;       ///< its time constant
    double strength_share = 0.1;    ///< the field's strength may differ by this share before it counts less
    double inclination_rad = 0.17;  ///< likewise its inclination

    double start_tilt_rad = 0.05, start_heading_rad = 0.2;
    double start_gyro_bias_rad_per_s = 0.02, start_accel_bias_m_per_s2 = 0.2;
    double start_gyro_scale = 0.01;
    double start_mag_lag_s = 0.015;
};

struct OrientationRun {
    std::vector<Quaterniond> q_world_sensor;  ///< of each reading
    std::vector<double> heading_sigma_rad;    ///< standard deviation of the heading, one per reading
    double mag_lag_s = 0;                     ///< how much later than the gyroscope the magnetometer tells
    double mag_lag_sigma_s = 0;
    Vector3d gyro_bias_rad_per_s = Vector3d::Zero();
};

/// Errors: kCancelled alone.
Result<OrientationRun> estimateOrientation(const ImuSamples& samples, const OrientationSettings& settings,
                                           const JobContext& job);

}  // namespace noctule
