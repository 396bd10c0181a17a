// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/limb_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/rotation.h"
#include "core/math/rotation_fit.h"

namespace noctule {
void LimbAlignment::breakOff(double time_s) {
    *this = LimbAlignment(parameters_);
    unbroken_s_ = 0;
    last_s_ = time_s;
}

void LimbAlignment::add(const Reading& reading, const Vector3d& force_joint_world) {
    const double dt_s = reading.time_s - std::exchange(last_s_, reading.time_s);
    const Vector3d& rate = reading.rate_rad_per_s;
    const auto last_rate = std::exchange(last_rate_rad_per_s_, rate);
    if (!last_rate)
        return;
    if (dt_s > parameters_.longest_s) {
        breakOff(reading.time_s);
        last_rate_rad_per_s_ = rate;
        return;
    }
    const Vector3d turn_accel = (rate - *last_rate) / dt_s;
    const Vector3d force_limb =
        reading.force_m_per_s2 - turn_accel.cross(reading.p_m) - rate.cross(rate.cross(reading.p_m));

    const auto motion = [](const Vector3d& force) {
        return std::abs(force.norm() - kStandardGravity_m_per_s2);
    };
    shaken_m_per_s2_ = std::max({motion(force_limb), motion(force_joint_world),
                                 shaken_m_per_s2_ * std::exp(-dt_s / parameters_.wobble_s)});
    const double error =
        std::hypot(parameters_.error_m_per_s2, parameters_.error_per_motion * shaken_m_per_s2_);
    const double weight = dt_s / (error * error);
    const double fading = std::exp(-dt_s / parameters_.memory_s);
    const Matrix3d turn = expQuaternion(0.5 * dt_s * (rate + *last_rate)).toRotationMatrix();
    profile_ = fading * profile_ * turn + weight * force_joint_world * force_limb.transpose();
    squares_ = fading * squares_ + weight * (force_joint_world.squaredNorm() + force_limb.squaredNorm());
    weight_s_ = fading * weight_s_ + dt_s;
    unbroken_s_ += dt_s;
}

std::optional<LimbAlignment::Found> LimbAlignment::contradict(const Matrix3d& R_world_limb) const {
    if (unbroken_s_ < parameters_.least_s || unbroken_s_ >= parameters_.suspected_s)
        return std::nullopt;
    const auto misfit = [this](const Matrix3d& R) { return squares_ - 2 * R.cwiseProduct(profile_).sum(); };
    // About a direction of which forces tell nothing the limb stays as believed; about others it is not held.
    const double hold = 0.25 * parameters_.alike_s;
    Matrix3d R = R_world_limb;
    for (int i = 0; i < 3; ++i)
        R = nearestRotation(profile_ + hold * R);
    const Quaterniond apart(Matrix3d(R_world_limb.transpose() * R));
    const double scale = std::max(misfit(R) / (3 * weight_s_), 1.0) * parameters_.alike_s;
    if (misfit(R_world_limb) - misfit(R) < scale * std::pow(parameters_.lost_sigma, 2) ||
        logQuaternion(apart).norm() < parameters_.lost_rad)
        return std::nullopt;
    const Matrix3d M = R.transpose() * profile_ + hold * Matrix3d::Identity();
    const Matrix3d information = M.trace() * Matrix3d::Identity() - 0.5 * (M + M.transpose());
    return Found{apart, scale * information.inverse().diagonal()};
}

}  // namespace noctule
