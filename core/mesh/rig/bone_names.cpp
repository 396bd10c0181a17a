// SPDX-License-Identifier: Apache-2.0
// Bones by the names that programs and data sets give them.
#include "core/body/bone_names.h"

#include "core/mesh/rig/bone_map.h"
#include "core/mesh/rig/rig_tree.h"

namespace noctule {
namespace {

/// One of many toes does not move the others: such a foot keeps its toes.
bool isOneOfManyToes(const RiggedMesh& mesh, int foot, const std::vector<bool>& moves) {
    constexpr int kToesAndHeel = 2;
    int moving = 0;
    for (size_t n = 0; n < mesh.nodes.size(); ++n)
        moving += mesh.nodes[n].parent == foot && moves[n];
    return moving > kToesAndHeel;
}

}  // namespace

BoneMap mapByNames(const RiggedMesh& mesh) {
    const std::vector<bool> moves =
        mesh.isRigged() ? movesSkin(mesh) : std::vector<bool>(mesh.nodes.size(), true);
    std::vector<NamedBone> bones;
    for (size_t n = 0; n < mesh.nodes.size(); ++n)
        bones.push_back({mesh.nodes[n].name, mesh.nodes[n].parent, moves[n]});
    std::map<std::string, int> found = jointsByName(bones).bone_of_joint;
    for (const std::string side : {"Left", "Right"})
        if (const auto foot = found.find(side + "Foot");
            foot != found.end() && isOneOfManyToes(mesh, foot->second, moves))
            found.erase(side + "ToeBase");
    BoneMap map;
    for (const auto& [joint, node] : found)
        map.node_of_joint[joint] = mesh.nodes[static_cast<size_t>(node)].name;
    return map;
}

}  // namespace noctule
