// SPDX-License-Identifier: Apache-2.0
#include "core/motion/joint_angles.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

using std::numbers::pi;

Vector3d turnsNearest(const Vector3d& angles, const Vector3d& near) {
    return angles - 2 * pi * ((angles - near) / (2 * pi)).array().round().matrix();
}

}  // namespace

Vector3d anglesZxy(const Quaterniond& q) {
    const Matrix3d r = q.normalized().toRotationMatrix();
    return {std::atan2(-r(0, 1), r(1, 1)), std::asin(std::clamp(r(2, 1), -1.0, 1.0)),
            std::atan2(-r(2, 0), r(2, 2))};
}

Vector3d anglesZxyNear(const Quaterniond& q, const Vector3d& near_rad) {
    const Vector3d angles = anglesZxy(q);
    const Vector3d one = turnsNearest(angles, near_rad);
    const Vector3d other = turnsNearest({angles[0] + pi, pi - angles[1], angles[2] + pi}, near_rad);
    return (one - near_rad).squaredNorm() <= (other - near_rad).squaredNorm() ? one : other;
}

Vector3d sigmaZxy(const Vector3d& angles_rad, const Vector3d& sigma_rad) {
    const Matrix3d to_body =
        (axisAngle(Vector3d::UnitX(), angles_rad[1]) * axisAngle(Vector3d::UnitY(), angles_rad[2]))
            .conjugate()
            .toRotationMatrix();
    Matrix3d J_rotation_angles;  // columns: what a change of z, x and y turns the body by, in its own frame
    J_rotation_angles.col(0) = to_body.col(2);
    J_rotation_angles.col(1) = axisAngle(Vector3d::UnitY(), angles_rad[2]).conjugate() * Vector3d::UnitX();
    J_rotation_angles.col(2) = Vector3d::UnitY();
    if (std::abs(std::cos(angles_rad[1])) < 1e-3)
        return Vector3d::Constant(pi);
    const Matrix3d J_angles_rotation = J_rotation_angles.inverse();
    const Vector3d variance = J_angles_rotation.cwiseAbs2() * sigma_rad.cwiseAbs2();
    return variance.cwiseSqrt().cwiseMin(pi);
}

}  // namespace noctule
