// SPDX-License-Identifier: Apache-2.0
#include "core/math/euler_sequence.h"

#include <cctype>
#include <cmath>

#include "core/math/euler.h"

namespace noctule {

namespace {

/// Below this sine of the middle angle first and last turn about one axis.
constexpr double kSameAxis = 1e-9;

Quaterniond aboutAxis(int axis, double angle_rad) {
    Quaterniond q(std::cos(angle_rad / 2), 0, 0, 0);
    q.vec()[axis] = std::sin(angle_rad / 2);
    return q;
}

Vector3d nearest(const Vector3d& angles_rad, const Vector3d& previous_rad) {
    const Vector3d turns = ((previous_rad - angles_rad) / (2 * std::numbers::pi)).array().round();
    return angles_rad + 2 * std::numbers::pi * turns;
}

/// With axes i, j, k and s = +-1 for even or odd orders, R = Ri(a) Rj(b) Ri(c) has
///   R_ii = cos(b), R_ji = sin(a) sin(b), R_ki = -s cos(a) sin(b).
/// b and c are read from Ri(-a) R = Rj(b) Ri(c), so that they fit whatever a was chosen.
Vector3d properAngles(const EulerSequence& sequence, const Matrix3d& R, double first_when_locked_rad) {
    const int i = sequence.first, j = sequence.second, k = 3 - i - j;
    const double s = (j - i + 3) % 3 == 1 ? 1 : -1;
    const bool locked = std::hypot(R(j, i), R(k, i)) < kSameAxis;
    const double a = locked ? first_when_locked_rad : std::atan2(R(j, i), -s * R(k, i));
    const double sa = s * std::sin(a), ca = std::cos(a);
    return {a, std::atan2(-s * (ca * R(k, i) - sa * R(j, i)), R(i, i)),
            std::atan2(-s * (ca * R(j, k) + sa * R(k, k)), ca * R(j, j) + sa * R(k, j))};
}

}  // namespace

std::optional<EulerSequence> eulerSequenceNamed(const std::string& name) {
    if (name.size() != 3)
        return std::nullopt;
    int axes[3];
    for (size_t n = 0; n < 3; ++n) {
        axes[n] = std::toupper(static_cast<unsigned char>(name[n])) - 'X';
        if (axes[n] < 0 || axes[n] > 2 || (n > 0 && axes[n] == axes[n - 1]))
            return std::nullopt;
    }
    return EulerSequence{axes[0], axes[1], axes[2]};
}

std::vector<std::string> eulerSequenceNames() {
    std::vector<std::string> names;
    for (const char first : {'X', 'Y', 'Z'})
        for (const char second : {'X', 'Y', 'Z'})
            for (const char third : {'X', 'Y', 'Z'})
                if (first != second && second != third)
                    names.push_back({first, second, third});
    return names;
}

Quaterniond rotationFromAngles(const EulerSequence& sequence, const Vector3d& angles_rad) {
    return aboutAxis(sequence.first, angles_rad[0]) * aboutAxis(sequence.second, angles_rad[1]) *
           aboutAxis(sequence.third, angles_rad[2]);
}

Vector3d anglesFromRotation(const EulerSequence& sequence, const Quaterniond& q,
                            const Vector3d& previous_rad) {
    if (!sequence.isProper())
        return eulerFromRotation({sequence.first, sequence.second, sequence.third}, q, previous_rad);
    const Vector3d principal = properAngles(sequence, q.normalized().toRotationMatrix(), previous_rad[0]);
    const Vector3d mirrored(principal[0] + std::numbers::pi, -principal[1], principal[2] + std::numbers::pi);
    const Vector3d one = nearest(principal, previous_rad), other = nearest(mirrored, previous_rad);
    return (one - previous_rad).squaredNorm() <= (other - previous_rad).squaredNorm() ? one : other;
}

}  // namespace noctule
