// SPDX-License-Identifier: Apache-2.0
// The default body: a smooth artist's figure made from a table of parts (mannequin_parts.h), fewer than 12
// 000 triangles, closed, symmetric. The same on every run; takes about two seconds.
#pragma once

#include "core/body/actor.h"
#include "core/mesh/skinned_mesh.h"

namespace noctule {

/// In the measures of `actor`, which has the canonical joints.
SkinnedMesh makeMannequin(const Actor& actor);

}  // namespace noctule
