// SPDX-License-Identifier: Apache-2.0
// Exponential map of SO(3) and what belongs to it. Rotation vectors in radians; all functions are accurate to
// rounding near zero. Formulas: Sola, Deray, Atchuthan 2018, "A micro Lie theory", eqs. 132-147.
#pragma once

#include "core/math/conventions.h"

namespace noctule {

/// [v]x, so that skew(v) * u = v cross u.
Matrix3d skew(const Vector3d& v);

/// Rotation vector -> unit quaternion.
Quaterniond expQuaternion(const Vector3d& rotation_vector);

/// Unit quaternion -> rotation vector with norm in [0, pi].
Vector3d logQuaternion(const Quaterniond& q);

/// Right Jacobian: exp(v + d) = exp(v) exp(Jr(v) d) to first order.
Matrix3d rightJacobian(const Vector3d& rotation_vector);

/// Half the sines of a rotation's turns about x, y, z: (R - R^T) / 4 as a vector. Smooth for every turn, and
/// linear in R.
Vector3d halfSines(const Matrix3d& R);

/// Geodesic angle between two rotations, 0..pi.
double angleBetween(const Quaterniond& a, const Quaterniond& b);

/// Rotation by `angle_rad` about a unit axis.
Quaterniond axisAngle(const Vector3d& unit_axis, double angle_rad);

/// The same turn seen in a mirror in the plane x = 0.
Quaterniond mirroredInX(const Quaterniond& q);

/// The smallest rotation that takes direction `from` to direction `to` (any lengths; opposite directions turn
/// about some perpendicular axis, of a zero vector nothing turns).
Quaterniond smallestRotation(const Vector3d& from, const Vector3d& to);

}  // namespace noctule
