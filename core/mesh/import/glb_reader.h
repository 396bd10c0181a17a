// SPDX-License-Identifier: Apache-2.0
// Skinned meshes from glTF 2.0 (.glb, .gltf). Bones carry canonical joint names or those of HumanIK and
// Mixamo
// ("mixamorig:LeftArm"); finer bones, such as fingers, are folded into the nearest known bone above them. The
// pose in which the file binds its skin is taken as the skeleton's zero pose (a T pose), its axes as ours.
#pragma once

#include <string>

#include "core/job/result.h"
#include "core/mesh/skinned_mesh.h"

namespace noctule {

/// All meshes of the file that have a skin, as one. kUnreadable: missing, damaged or not glTF; kUnusable: no
/// skin, or bones that belong to no joint, by name.
Result<SkinnedMesh> readSkinnedMesh(const std::string& path);

/// Of assimp, which reads it: "5.2.5".
std::string meshReaderVersion();

/// The canonical joint behind a bone's name, or empty.
std::string canonicalJointOf(const std::string& bone);

}  // namespace noctule
