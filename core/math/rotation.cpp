// SPDX-License-Identifier: Apache-2.0
#include "core/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace noctule {

Matrix3d skew(const Vector3d& v) {
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Quaterniond expQuaternion(const Vector3d& rotation_vector) {
    const double angle_squared = rotation_vector.squaredNorm();
    double w = 0, scale = 0;  // q = (w, scale * rotation_vector)
    if (angle_squared < 1e-8) {
        w = 1 - angle_squared / 8;
        scale = 0.5 - angle_squared / 48;
    } else {
        const double angle = std::sqrt(angle_squared);
        w = std::cos(angle / 2);
        scale = std::sin(angle / 2) / angle;
    }
    return {w, scale * rotation_vector.x(), scale * rotation_vector.y(), scale * rotation_vector.z()};
}

Vector3d logQuaternion(const Quaterniond& q) {
    const double sign = q.w() < 0 ? -1.0 : 1.0;  // q and -q are one rotation; take the short way
    const double sine = q.vec().norm();
    const double cosine = sign * q.w();
    if (sine < 1e-8)
        return 2 * sign * q.vec() / std::max(cosine, 1e-12);
    return sign * 2 * std::atan2(sine, cosine) / sine * q.vec();
}

Matrix3d rightJacobian(const Vector3d& rotation_vector) {
    const double angle_squared = rotation_vector.squaredNorm();
    double a = 0, b = 0;  // Jr = I - a [v]x + b [v]x^2
    if (angle_squared < 1e-6) {
        a = 0.5 - angle_squared / 24;
        b = 1.0 / 6 - angle_squared / 120;
    } else {
        const double angle = std::sqrt(angle_squared);
        a = (1 - std::cos(angle)) / angle_squared;
        b = (angle - std::sin(angle)) / (angle_squared * angle);
    }
    const Matrix3d cross = skew(rotation_vector);
    return Matrix3d::Identity() - a * cross + b * cross * cross;
}

Vector3d halfSines(const Matrix3d& R) {
    return Vector3d(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)) / 4;
}

double angleBetween(const Quaterniond& a, const Quaterniond& b) {
    const Quaterniond difference = a.conjugate() * b;
    return 2 * std::atan2(difference.vec().norm(), std::abs(difference.w()));
}

Quaterniond axisAngle(const Vector3d& unit_axis, double angle_rad) {
    return Quaterniond(Eigen::AngleAxisd(angle_rad, unit_axis));
}

Quaterniond mirroredInX(const Quaterniond& q) {
    return {q.w(), q.x(), -q.y(), -q.z()};
}

Quaterniond smallestRotation(const Vector3d& from, const Vector3d& to) {
    const Vector3d a = from.normalized(), b = to.normalized();
    const double twice_w = (a + b).norm();
    if (a.isZero() || b.isZero())
        return Quaterniond::Identity();
    if (twice_w < 1e-9) {
        const Vector3d axis = a.unitOrthogonal();
        return {0, axis.x(), axis.y(), axis.z()};
    }
    const Vector3d v = a.cross(b) / twice_w;
    return Quaterniond(twice_w / 2, v.x(), v.y(), v.z()).normalized();
}

}  // namespace noctule
