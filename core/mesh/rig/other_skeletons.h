// SPDX-License-Identifier: Apache-2.0
// Skeletons in a file beside the one that wears our motion: clothes with an armature of their own, and other
// people.
#pragma once

#include "core/mesh/rig/bone_map.h"

namespace noctule {

/// Per node whether it belongs to another body, which stands where the file has it: a human skeleton beside
/// the mapped one whose joints stand elsewhere, or bones without known names whose skin lies beside the body.
/// Anything else beside the mapped hips (hair, eyes, shoes) goes along with them.
std::vector<bool> nodesOfOtherBodies(const RiggedMesh& mesh, const BoneMap& map);

/// The same mesh with clothes on the body's own bones: a skeleton beside the mapped one whose joints stand
/// where the body's do is taken for it, and what hangs on it hangs on the body. Rest pose and skin stay.
RiggedMesh dressed(RiggedMesh mesh, const BoneMap& map);

}  // namespace noctule
