// SPDX-License-Identifier: Apache-2.0
// Euler angles about three different axes, as animation files and biomechanics write rotations: the order
// (2, 0, 1) is R = Rz(e[0]) * Rx(e[1]) * Ry(e[2]), each about the axes that the ones before it have turned.
// Angles in radians, any size.
#pragma once

#include <array>

#include "core/math/conventions.h"

namespace noctule {

/// A permutation of the axes 0 = x, 1 = y, 2 = z.
using EulerOrder = std::array<int, 3>;

inline constexpr EulerOrder kEulerXYZ{0, 1, 2}, kEulerXZY{0, 2, 1}, kEulerYXZ{1, 0, 2};
inline constexpr EulerOrder kEulerYZX{1, 2, 0}, kEulerZXY{2, 0, 1}, kEulerZYX{2, 1, 0};

Quaterniond rotationFromEuler(const EulerOrder& order, const Vector3d& angles_rad);

/// The angles with the middle one in [-pi/2, pi/2] and the others in [-pi, pi].
Vector3d eulerFromRotation(const EulerOrder& order, const Quaterniond& q);

/// Of all triples that give this rotation the one nearest to `previous_rad`, so that curves neither jump by a
/// turn nor flip to the other branch; where the rotation does not determine them (gimbal lock) the first
/// angle stays as it was.
Vector3d eulerFromRotation(const EulerOrder& order, const Quaterniond& q, const Vector3d& previous_rad);

}  // namespace noctule
