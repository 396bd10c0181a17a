// SPDX-License-Identifier: Apache-2.0
// The error state of orientation_filter.h: what is estimated, how it moves in one step, how one number
// corrects it. Turns are errors in the world: R = exp(turn) R_hat.
#pragma once

#include <Eigen/Core>

#include "core/orientation/orientation_filter.h"

namespace noctule::orientation {

/// First index of each part of the error state.
enum Part { kTurn = 0, kVelocity = 3, kPlace = 6, kGyroBias = 9, kAccelBias = 12, kGyroScale = 15 };
inline constexpr int kDisturbance = 18, kMagLag = 19, kSize = 20;

using ErrorVector = Eigen::Matrix<double, kSize, 1>;
using ErrorMatrix = Eigen::Matrix<double, kSize, kSize>;

/// The estimate itself.
struct Nominal {
    Quaterniond q_world_sensor = Quaterniond::Identity();
    Vector3d velocity_m_per_s = Vector3d::Zero();
    Vector3d place_m = Vector3d::Zero();
    Vector3d gyro_bias_rad_per_s = Vector3d::Zero();
    Vector3d accel_bias_m_per_s2 = Vector3d::Zero();
    Vector3d gyro_scale = Vector3d::Zero();  ///< relative: rate = (1 + scale) * reading - bias
    double disturbance_rad = 0;              ///< by how much the field's heading differs from Z
    double mag_lag_s = 0;

    Vector3d rate(const Vector3d& reading_rad_per_s) const {
        return reading_rad_per_s + gyro_scale.cwiseProduct(reading_rad_per_s) - gyro_bias_rad_per_s;
    }
    void add(const ErrorVector& error);
};

/// Sums over the readings of one step, which make its transition.
struct Transition {
    double dt_s = 0;
    Matrix3d turn_by_bias = Matrix3d::Zero();   ///< -integral of R
    Matrix3d turn_by_scale = Matrix3d::Zero();  ///< integral of R diag(reading)
    Vector3d force_dt = Vector3d::Zero();       ///< integral of R times the specific force, m/s
    double missing_turn_rad2 = 0;               ///< variance for readings that were missing
    double missing_velocity_m2_per_s2 = 0;
    double disturbance_decay = 1;
};

/// F times `m`, in place: `m` has the error state along its rows.
void applyTransition(const Transition& t, ErrorMatrix& m);
/// F P F^T + Q.
ErrorMatrix predictCovariance(const Transition& t, const ErrorMatrix& P, const OrientationSettings& settings);
ErrorMatrix startCovariance(const OrientationSettings& settings);

/// After `error` was added to the estimate: a common turn about the vertical, which no pseudo-measurement
/// sees, now moves velocity and place by other amounts. Without this the heading would seem to become known.
void keepHeadingUnseen(const ErrorVector& error, ErrorMatrix& P);

/// Adds to `error` and lowers `P` by a measurement y = h error + noise.
void correct(const ErrorVector& h, double y, double variance, ErrorVector& error, ErrorMatrix& P);

}  // namespace noctule::orientation
