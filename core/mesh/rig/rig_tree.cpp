// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/rig_tree.h"

#include <algorithm>

namespace noctule {
namespace {

int parentOf(const RiggedMesh& mesh, int node) {
    return mesh.nodes[static_cast<size_t>(node)].parent;
}

}  // namespace

bool hangsOn(const RiggedMesh& mesh, int node, int above) {
    while (node > above)  // parents come first
        node = parentOf(mesh, node);
    return node == above && node >= 0;
}

int commonAncestor(const RiggedMesh& mesh, int a, int b) {
    while (a != b && a >= 0 && b >= 0)
        (a > b ? a : b) = parentOf(mesh, std::max(a, b));
    return a == b ? a : -1;
}

std::vector<int> chainBelow(const RiggedMesh& mesh, int above, int node) {
    std::vector<int> chain;
    for (; node > above; node = parentOf(mesh, node))
        chain.push_back(node);
    if (node != above)
        return {};
    std::reverse(chain.begin(), chain.end());
    return chain;
}

std::vector<std::vector<int>> childrenOf(const RiggedMesh& mesh) {
    std::vector<std::vector<int>> children(mesh.nodes.size());
    for (size_t n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].parent >= 0)
            children[static_cast<size_t>(mesh.nodes[n].parent)].push_back(static_cast<int>(n));
    return children;
}

std::vector<bool> movesSkin(const RiggedMesh& mesh) {
    std::vector<bool> moves(mesh.nodes.size(), false);
    for (const int node : mesh.node_of_bone)
        moves[static_cast<size_t>(node)] = true;
    for (size_t n = mesh.nodes.size(); n-- > 0;)
        if (moves[n] && mesh.nodes[n].parent >= 0)
            moves[static_cast<size_t>(mesh.nodes[n].parent)] = true;
    return moves;
}

}  // namespace noctule
