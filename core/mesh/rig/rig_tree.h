// SPDX-License-Identifier: Apache-2.0
// Questions about the tree of a rig's nodes. Indices as in RiggedMesh::nodes; -1 is "none".
#pragma once

#include <vector>

#include "core/mesh/rigged_mesh.h"

namespace noctule {

/// Whether `node` is `above` or below it.
bool hangsOn(const RiggedMesh& mesh, int node, int above);
/// The deepest node on which both hang; -1 when there is none.
int commonAncestor(const RiggedMesh& mesh, int a, int b);
/// From just below `above` down to `node`; empty when it does not hang there.
std::vector<int> chainBelow(const RiggedMesh& mesh, int above, int node);
std::vector<std::vector<int>> childrenOf(const RiggedMesh& mesh);
/// Which nodes move vertices, they or one below them.
std::vector<bool> movesSkin(const RiggedMesh& mesh);

}  // namespace noctule
