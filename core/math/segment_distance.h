// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/conventions.h"

namespace noctule {

/// Shortest distance of two line segments, which may be points (Ericson, "Real-Time Collision Detection",
/// section 5.1.9).
double segmentDistance(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1);

}  // namespace noctule
