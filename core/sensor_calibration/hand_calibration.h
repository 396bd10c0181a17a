// SPDX-License-Identifier: Apache-2.0
// Accelerometer and gyroscope calibrated by hand: the sensor is laid down still in many positions and turned
// between them. Source: Tedaldi, Pretto, Menegatti, "A robust and easy to implement method for IMU
// calibration without external equipments", ICRA 2014: stillness by variance, the accelerometer by gravity's
// length, the gyroscope by carrying gravity's direction from one position to the next.
#pragma once

#include <string>
#include <vector>

#include "core/orientation/imu_samples.h"
#include "core/sensor_calibration/ellipsoid_fit.h"

namespace noctule {

/// Rows `begin` to `end` in which the sensor lay still.
struct StillRows {
    size_t begin = 0, end = 0;
    Vector3d accel = Vector3d::Zero(), gyro = Vector3d::Zero();  ///< means
};

/// Windows of a second whose variance of the acceleration is below `factor` squared times the least of all.
std::vector<StillRows> findStillRows(const ImuSamples& samples, double factor);

struct GyroscopeHandFit {
    Vector3d zero = Vector3d::Zero(), sigma_zero = Vector3d::Zero();
    Matrix3d matrix = Matrix3d::Identity();  ///< scale and misalignment into the accelerometer's axes
    double residual_deg = 0;                 ///< rms between gravity carried and gravity seen
    double before_deg = 0;                   ///< the same with the matrix 1
    Vector3d turned_deg = Vector3d::Zero();  ///< about each axis in all
    double condition = 0;
    int turns = 0;
    bool converged = false;
};

struct HandFit {
    EllipsoidFit accel;
    GyroscopeHandFit gyro;
    size_t positions = 0;
    double before_m_per_s2 = 0;   ///< rms of |acceleration| minus gravity at rest, as read
    DirectionCoverage coverage;   ///< of gravity in the sensor's frame
    std::string problem, remedy;  ///< why it must not be used; empty: usable
};

/// `samples` roughly in SI, as nominal values or a former calibration give it. The fit is applied on top:
/// value = matrix * (sample - zero).
HandFit calibrateByHand(const ImuSamples& samples, double g_m_per_s2);

}  // namespace noctule
