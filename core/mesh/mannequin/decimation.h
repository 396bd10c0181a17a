// SPDX-License-Identifier: Apache-2.0
// Fewer triangles for the same shape: edge collapses in the order of their quadric error (Garland & Heckbert
// 1997, "Surface simplification using quadric error metrics"), with a small price on length so that triangles
// stay even where the surface is flat.
#pragma once

#include <functional>

#include "core/mesh/triangle_mesh.h"

namespace noctule {

/// How much an error counts at a place, 1 by default.
using Importance = std::function<double(const Vector3d& p_m)>;

/// At most `target` triangles where the shape allows it. Points of an open border on x = 0 stay there; the
/// surface stays a manifold.
TriangleMesh decimated(const TriangleMesh& mesh, size_t target, const Importance& importance);

}  // namespace noctule
