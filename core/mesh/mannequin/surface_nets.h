// SPDX-License-Identifier: Apache-2.0
// Polygons of an implicit surface by surface nets (Gibson 1998, "Constrained elastic surface nets"): one
// point per cell that the surface passes, one quadrangle per grid edge that it crosses.
#pragma once

#include "core/mesh/mannequin/implicit_body.h"
#include "core/mesh/triangle_mesh.h"

namespace noctule {

/// The half x >= 0 of a body that is symmetric about x = 0, in cells of `cell_m`; its border lies on x = 0
/// exactly. Fine enough when the thinnest part measures about four cells.
TriangleMesh polygoniseHalf(const ImplicitBody& body, double cell_m);

/// The whole of it: the half and its mirror image, points of the border shared.
TriangleMesh mirrored(const TriangleMesh& half);

}  // namespace noctule
