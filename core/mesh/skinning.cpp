// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/skinning.h"

namespace noctule {

PosedSurface skinned(const SkinnedMesh& mesh, const std::vector<Eigen::Matrix4f>& skin_matrices) {
    require(skin_matrices.size() == mesh.bones.size(), "skinned() needs one matrix per bone");
    PosedSurface surface;
    surface.points_m.reserve(mesh.vertices.size());
    surface.normals.reserve(mesh.vertices.size());
    for (const SkinnedVertex& vertex : mesh.vertices) {
        Eigen::Matrix4f blend = Eigen::Matrix4f::Zero();
        for (size_t i = 0; i < 4; ++i)
            blend += vertex.weights[i] * skin_matrices[vertex.bones[i]];
        surface.points_m.emplace_back((blend * vertex.p_m.homogeneous()).head<3>());
        surface.normals.emplace_back((blend.topLeftCorner<3, 3>() * vertex.normal).normalized());
    }
    return surface;
}

}  // namespace noctule
