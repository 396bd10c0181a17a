// SPDX-License-Identifier: Apache-2.0
// Rotations and placements that fit best in least squares (Kabsch 1976; Umeyama 1991).
#pragma once

#include "core/math/conventions.h"

namespace noctule {

/// M must be finite. The rotation R that makes |R - M| least, and trace(R^T M) greatest: M may be a sum of
/// rotations or of products b a^T of vectors that R takes from a to b.
Matrix3d nearestRotation(const Matrix3d& M);

/// T that makes the sum of |to_i - T from_i|^2 least; one point a column, at least three that no line holds.
Eigen::Isometry3d rigidFit(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to);
/// The same, where T may scale as well.
Eigen::Affine3d similarityFit(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to);

}  // namespace noctule
