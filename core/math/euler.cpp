// SPDX-License-Identifier: Apache-2.0
#include "core/math/euler.h"

#include <cmath>

#include "core/job/contract.h"

namespace noctule {
namespace {

using std::numbers::pi;

/// Below this cosine of the middle angle the first angle is taken as undetermined; the rotation is then wrong
/// by at most as many radians.
constexpr double kGimbalLock = 1e-9;

double parity(const EulerOrder& order) {
    const bool permutation = order[0] != order[1] && order[1] != order[2] && order[0] != order[2];
    require(
        permutation && order[0] + order[1] + order[2] == 3 && order[0] >= 0 && order[1] >= 0 && order[2] >= 0,
        "an Euler order is a permutation of the three axes");
    return (order[1] - order[0] + 3) % 3 == 1 ? 1 : -1;
}

/// With axes i, j, k and s = +-1 for even or odd orders, R = Ri(a) Rj(b) Rk(c) has
///   R_jk = -s sin(a) cos(b), R_kk = cos(a) cos(b), R_ik = s sin(b).
/// b and c are read from Ri(-a) R = Rj(b) Rk(c), so that they fit whatever a was chosen, also near the lock.
Vector3d anglesGivenFirst(const EulerOrder& order, double s, const Matrix3d& R, double a) {
    const auto [i, j, k] = order;
    const double sa = s * std::sin(a), ca = std::cos(a);
    return {a, std::atan2(s * R(i, k), ca * R(k, k) - sa * R(j, k)),
            std::atan2(s * (ca * R(j, i) + sa * R(k, i)), ca * R(j, j) + sa * R(k, j))};
}

Vector3d extract(const EulerOrder& order, const Quaterniond& q, double first_when_locked_rad) {
    const double s = parity(order);
    const Matrix3d R = q.normalized().toRotationMatrix();
    const double sine = -s * R(order[1], order[2]), cosine = R(order[2], order[2]);
    const bool locked = std::hypot(sine, cosine) < kGimbalLock;
    return anglesGivenFirst(order, s, R, locked ? first_when_locked_rad : std::atan2(sine, cosine));
}

Vector3d unwrapped(const Vector3d& angles_rad, const Vector3d& previous_rad) {
    const Vector3d turns = ((previous_rad - angles_rad) / (2 * pi)).array().round();
    return angles_rad + 2 * pi * turns;
}

}  // namespace

Quaterniond rotationFromEuler(const EulerOrder& order, const Vector3d& angles_rad) {
    parity(order);
    Quaterniond q = Quaterniond::Identity();
    for (int n = 0; n < 3; ++n) {
        Quaterniond about_axis(std::cos(angles_rad[n] / 2), 0, 0, 0);
        about_axis.vec()[order[static_cast<size_t>(n)]] = std::sin(angles_rad[n] / 2);
        q = q * about_axis;
    }
    return q;
}

Vector3d eulerFromRotation(const EulerOrder& order, const Quaterniond& q) {
    return extract(order, q, 0);
}

Vector3d eulerFromRotation(const EulerOrder& order, const Quaterniond& q, const Vector3d& previous_rad) {
    const Vector3d principal = extract(order, q, previous_rad[0]);
    const Vector3d mirrored(principal[0] + pi, pi - principal[1], principal[2] + pi);
    const Vector3d first = unwrapped(principal, previous_rad), second = unwrapped(mirrored, previous_rad);
    return (first - previous_rad).squaredNorm() <= (second - previous_rad).squaredNorm() ? first : second;
}

}  // namespace noctule
