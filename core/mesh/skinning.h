// SPDX-License-Identifier: Apache-2.0
// Linear blend skinning on the processor, for tests and pictures; the 3D view does the same in its shader.
#pragma once

#include "core/mesh/skinned_mesh.h"

namespace noctule {

struct PosedSurface {
    std::vector<Eigen::Vector3f> points_m;  ///< world, one per vertex
    std::vector<Eigen::Vector3f> normals;
};

/// `skin_matrices` as from skinMatrices().
PosedSurface skinned(const SkinnedMesh& mesh, const std::vector<Eigen::Matrix4f>& skin_matrices);

}  // namespace noctule
