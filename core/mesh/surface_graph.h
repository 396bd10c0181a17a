// SPDX-License-Identifier: Apache-2.0
// A surface as a graph: vertices in one place made one, ways along its edges, and rings, the closed lines on
// which a value that every vertex has (its height, its way to a fingertip) takes one level.
#pragma once

#include <vector>

#include "core/mesh/skinned_mesh.h"
#include "core/mesh/triangle_mesh.h"

namespace noctule {

struct WeldedSurface {
    TriangleMesh mesh;               ///< without triangles that have lost their area
    std::vector<uint32_t> point_of;  ///< per vertex of the skin, index into mesh.points
};
WeldedSurface welded(const SkinnedMesh& skin);

/// Which connected piece of the surface a point belongs to, from 0 for that with most points.
std::vector<int> piecesOf(const TriangleMesh& mesh);

/// Length of the shortest way along edges from a point to every other (Dijkstra); infinite where there is
/// none.
std::vector<double> waysFrom(const TriangleMesh& mesh, uint32_t point);

struct Ring {
    Vector3d centre = Vector3d::Zero();  ///< mean along the line
    double length = 0;
    Eigen::AlignedBox3d box;
};
/// The rings of one level; infinite values belong to nothing.
std::vector<Ring> ringsAt(const TriangleMesh& mesh, const std::vector<double>& value, double level);

}  // namespace noctule
