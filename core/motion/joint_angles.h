// SPDX-License-Identifier: Apache-2.0
// Three Euler angles of a rotation for plots (Vlasic 2007, figure 6): R = Rz(z) Rx(x) Ry(y), the classical
// order of BVH channels. Singular at x = +-90 degrees, where the angles say little; differences between
// motions are therefore always measured by the angle between rotations and never by these.
#pragma once

#include "core/math/conventions.h"

namespace noctule {

/// (z, x, y) in radians; x within +-pi/2.
Vector3d anglesZxy(const Quaterniond& q);

/// The same rotation's angles nearest to `near`: free of the jumps at +-pi and at the singularity's far side.
Vector3d anglesZxyNear(const Quaterniond& q, const Vector3d& near_rad);

/// Standard deviations of the three angles from those of a right perturbation (rad), to first order; pi at
/// most, which is what remains near the singularity.
Vector3d sigmaZxy(const Vector3d& angles_rad, const Vector3d& sigma_rad);

}  // namespace noctule
