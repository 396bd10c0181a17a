// SPDX-License-Identifier: Apache-2.0
// The one page on frames, units and rotations.
//
// Units    SI and radians; time as int64 nanoseconds or as a sample index of the suit's clock. All data of
// one
//          suit share one sample clock. Degrees and centimetres exist only on screens and in files that want
//          them.
// World    right-handed; Y up, Z the performer's forward in the rest pose, X to the performer's left.
//          Gravity is (0, -g, 0); an accelerometer at rest reads +g upward.
// Rotation Hamilton unit quaternions; q_a_b takes vectors of frame b to frame a. Rotation errors are right
//          (local) perturbations: R = R_hat * exp(delta).
// Names    q_world_segment, p_world_sensor, J_range_theta, sigma_range_m: frames so that chains cancel, and a
//          unit wherever the type does not show it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace noctule {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

inline constexpr double kStandardGravity_m_per_s2 = 9.80665;

inline constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}
inline constexpr double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

}  // namespace noctule
