// SPDX-License-Identifier: Apache-2.0
// The skin of a foot that can touch the ground, and how far the foot has to turn so that it does not go
// below.
#pragma once

#include <vector>

#include "core/mesh/rigged_mesh.h"

namespace noctule {

/// Of the vertices that hang mostly on the chosen nodes, those that lie lowest when their part is turned
/// somehow, but not upside down: some dozens. In the mesh's world at rest, in which `up` points up.
std::vector<Vector3d> lowestSkin(const RiggedMesh& mesh, const std::vector<bool>& nodes, const Vector3d& up);

/// The smallest turn about a horizontal `axis` through `centre`, from 0 to `most_rad` (of either sign), with
/// which no point lies below `floor_m` (world, Y up); else as far as that lifts the lowest.
double turnAboveFloor(const std::vector<Vector3d>& points, const Vector3d& centre, const Vector3d& axis,
                      double floor_m, double most_rad);

}  // namespace noctule
