// SPDX-License-Identifier: Apache-2.0
// Skinning on the processor, for tests, exports and pictures; the 3D view does the same in its shader. Linear
// blending is what other programs do by default and what files mean; dual quaternions (Kavan et al. 2007,
// "Skinning with dual quaternions") keep the volume of joints that bend or twist far. Stretching parts of the
// matrices are blended linearly before the turn.
#pragma once

#include "core/mesh/skinned_mesh.h"

namespace noctule {

struct PosedSurface {
    std::vector<Eigen::Vector3f> points_m;  ///< world, one per vertex
    std::vector<Eigen::Vector3f> normals;
};

enum class Blending { kLinear, kDualQuaternion };

/// `skin_matrices` as from skinMatrices(), one per bone.
PosedSurface skinned(const SkinnedMesh& mesh, const std::vector<Eigen::Matrix4f>& skin_matrices,
                     Blending blending = Blending::kLinear);

/// A matrix as a rigid motion after a stretch: M = motion * stretch. Mirrored ones keep the mirror in the
/// stretch.
struct DualBone {
    Eigen::Vector4f real{0, 0, 0, 1};  ///< x, y, z, w of a unit quaternion
    Eigen::Vector4f dual{0, 0, 0, 0};
    Eigen::Matrix3f stretch = Eigen::Matrix3f::Identity();
};
std::vector<DualBone> dualBones(const std::vector<Eigen::Matrix4f>& skin_matrices);

}  // namespace noctule
