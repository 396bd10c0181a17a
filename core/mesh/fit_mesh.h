// SPDX-License-Identifier: Apache-2.0
// A body in the measures of another performer: every segment is stretched along its bones, in width it
// follows the performer's height, and the skin between segments moves by its weights.
#pragma once

#include "core/mesh/skinned_mesh.h"

namespace noctule {

/// `from` is the skeleton the mesh was made for, `to` the performer's. Joints are matched by name; a bone
/// that one of them lacks follows its nearest ancestor.
SkinnedMesh fitted(const SkinnedMesh& mesh, const Skeleton& from, const Skeleton& to);

}  // namespace noctule
