// SPDX-License-Identifier: Apache-2.0
// A body in the measures of another performer: every segment is stretched along its bones, in width it
// follows the performer's height, and the skin between segments moves by its weights. Limbs point as in the
// performer's zero pose, and feet are turned so that they lie flat when the performer's do.
#pragma once

#include "core/mesh/retarget/feet_at_rest.h"
#include "core/mesh/skinned_mesh.h"

namespace noctule {

/// `from` is the skeleton the mesh was made for, with limbs and feet as the default actor's; `to` the
/// performer's, `feet` as the performer's lie flat. Joints are matched by name; a bone
/// that one of them lacks follows its nearest ancestor.
SkinnedMesh fitted(const SkinnedMesh& mesh, const Skeleton& from, const Skeleton& to,
                   const FeetAtRest& feet = {});

}  // namespace noctule
