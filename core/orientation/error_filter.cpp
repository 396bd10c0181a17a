// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/error_filter.h"

#include "core/math/rotation.h"

namespace noctule::orientation {

void Nominal::add(const ErrorVector& error) {
    q_world_sensor = (expQuaternion(error.segment<3>(kTurn)) * q_world_sensor).normalized();
    velocity_m_per_s += error.segment<3>(kVelocity);
    place_m += error.segment<3>(kPlace);
    gyro_bias_rad_per_s += error.segment<3>(kGyroBias);
    accel_bias_m_per_s2 += error.segment<3>(kAccelBias);
    gyro_scale += error.segment<3>(kGyroScale);
    disturbance_rad += error[kDisturbance];
    mag_lag_s += error[kMagLag];
}

void applyTransition(const Transition& t, ErrorMatrix& m) {
    // From the last part to the first, so that each reads what the step began with.
    const Eigen::Matrix<double, 3, kSize> velocity_gain =
        -skew(t.force_dt) * m.middleRows<3>(kTurn) + t.turn_by_bias * m.middleRows<3>(kAccelBias);
    m.middleRows<3>(kPlace) += t.dt_s * (m.middleRows<3>(kVelocity) + velocity_gain / 2);
    m.middleRows<3>(kVelocity) += velocity_gain;
    m.middleRows<3>(kTurn) +=
        t.turn_by_bias * m.middleRows<3>(kGyroBias) + t.turn_by_scale * m.middleRows<3>(kGyroScale);
    m.row(kDisturbance) *= t.disturbance_decay;
}

ErrorMatrix predictCovariance(const Transition& t, const ErrorMatrix& P,
                              const OrientationSettings& settings) {
    ErrorMatrix m = P;
    applyTransition(t, m);
    m.transposeInPlace();
    applyTransition(t, m);
    const auto walk = [&](int part, double per_sqrt_s, double extra) {
        m.diagonal().segment<3>(part).array() += per_sqrt_s * per_sqrt_s * t.dt_s + extra;
    };
    walk(kTurn, settings.gyro_noise_rad_per_sqrt_s, t.missing_turn_rad2);
    walk(kVelocity, settings.accel_noise_m_per_s_sqrt_s, t.missing_velocity_m2_per_s2);
    walk(kGyroBias, settings.gyro_walk_rad_per_s_sqrt_s, 0);
    walk(kAccelBias, settings.accel_walk_m_per_s2_sqrt_s, 0);
    m(kDisturbance, kDisturbance) +=
        settings.disturbance_rad * settings.disturbance_rad * (1 - t.disturbance_decay * t.disturbance_decay);
    return m;
}

ErrorMatrix startCovariance(const OrientationSettings& s) {
    ErrorVector sigma;
    sigma << s.start_tilt_rad, s.start_heading_rad, s.start_tilt_rad,  //
        Vector3d::Constant(s.velocity_m_per_s), Vector3d::Constant(s.place_m),
        Vector3d::Constant(s.start_gyro_bias_rad_per_s), Vector3d::Constant(s.start_accel_bias_m_per_s2),
        Vector3d::Constant(s.start_gyro_scale), s.disturbance_rad, s.start_mag_lag_s;
    return sigma.cwiseAbs2().asDiagonal();
}

void correct(const ErrorVector& h, double y, double variance, ErrorVector& error, ErrorMatrix& P) {
    const ErrorVector Ph = P * h;
    const double innovation_variance = h.dot(Ph) + variance;
    const ErrorVector gain = Ph / innovation_variance;
    error += gain * (y - h.dot(error));
    P.noalias() -= gain * Ph.transpose();
}

void keepHeadingUnseen(const ErrorVector& error, ErrorMatrix& P) {
    Eigen::Matrix<double, 6, 1> shift;
    shift << Vector3d::UnitY().cross(error.segment<3>(kVelocity)),
        Vector3d::UnitY().cross(error.segment<3>(kPlace));
    P.middleRows<6>(kVelocity).noalias() += shift * P.row(kTurn + 1).eval();
    P.middleCols<6>(kVelocity).noalias() += P.col(kTurn + 1).eval() * shift.transpose();
}

}  // namespace noctule::orientation
