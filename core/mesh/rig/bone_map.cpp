// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/bone_map.h"

#include <algorithm>

#include "core/body/actor.h"
#include "core/job/atomic_file.h"
#include "core/math/json.h"
#include "core/mesh/rig/rig_tree.h"

namespace noctule {
namespace {

constexpr int kFormatVersion = 1;
constexpr const char* kFormat = "noctule-bone-map";

Error wrongMap(const std::string& where, const std::string& what) {
    return {ErrorKind::kUnusable, where + ": " + what, "Choose another bone for it"};
}

Error noMap(const std::string& where) {
    return {ErrorKind::kUnreadable, where + ": this is no map of bones",
            "Choose a file that was saved as a bone map"};
}

/// The node of the nearest joint above that has one; -1 when none has.
int nodeAbove(const BoneMap& map, const RiggedMesh& mesh, const Skeleton& skeleton, int joint) {
    for (int j = skeleton.joint(joint).parent; j >= 0; j = skeleton.joint(j).parent)
        if (const auto found = map.node_of_joint.find(skeleton.joint(j).name);
            found != map.node_of_joint.end())
            return mesh.find(found->second);
    return -1;
}

}  // namespace

std::vector<std::string> missingMainJoints(const BoneMap& map) {
    std::vector<std::string> missing;
    for (const std::string& joint : mainJoints())
        if (!map.node_of_joint.contains(joint))
            missing.push_back(joint);
    return missing;
}

BoneMap findBoneMap(const RiggedMesh& mesh) {
    if (const BoneMap told{mesh.humanoid}; missingMainJoints(told).empty() && checkBoneMap(told, mesh, ""))
        return told;
    BoneMap named = mapByNames(mesh);
    if (missingMainJoints(named).empty() && checkBoneMap(named, mesh, ""))
        return named;
    BoneMap shaped = mapByShape(mesh);
    return missingMainJoints(shaped).size() < missingMainJoints(named).size() ? shaped : named;
}

Status checkBoneMap(const BoneMap& map, const RiggedMesh& mesh, const std::string& where) {
    static const Skeleton skeleton = defaultActor().skeleton;
    std::map<std::string, std::string> joint_of_node;
    for (const auto& [joint, node] : map.node_of_joint) {
        if (skeleton.find(joint) < 0)
            return wrongMap(where, "there is no joint " + joint);
        if (mesh.find(node) < 0)
            return wrongMap(where, "the mesh has no bone " + node + ", which is to be " + joint);
        const auto [other, is_new] = joint_of_node.try_emplace(node, joint);
        if (!is_new)
            return wrongMap(where, "the bone " + node + " is to be both " + other->second + " and " + joint);
        const int above = nodeAbove(map, mesh, skeleton, skeleton.find(joint));
        if (above >= 0 && !hangsOn(mesh, mesh.find(node), above))
            return wrongMap(where, "the bone " + node + ", which is to be " + joint +
                                       ", does not hang below " +
                                       mesh.nodes[static_cast<size_t>(above)].name);
    }
    if (const auto missing = missingMainJoints(map); !missing.empty())
        return wrongMap(where, "no bone is " + missing.front());
    return Done{};
}

nlohmann::json toJson(const BoneMap& map) {
    return {{"format", kFormat}, {"version", kFormatVersion}, {"bones", map.node_of_joint}};
}

Result<BoneMap> boneMapFromJson(const nlohmann::json& json, const std::string& where) {
    const auto version = json::number(json, "version");
    if (json::text(json, "format") != kFormat || !version)
        return noMap(where);
    if (*version != kFormatVersion)
        return Error{ErrorKind::kUnreadable,
                     where + ": a newer version of the program wrote this map of bones",
                     "Open it with that version, or map the bones again"};
    const auto bones = json.find("bones");
    if (bones == json.end() || !bones->is_object())
        return noMap(where);
    BoneMap map;
    for (const auto& [joint, node] : bones->items()) {
        if (!node.is_string())
            return noMap(where);
        map.node_of_joint[joint] = node.get<std::string>();
    }
    return map;
}

Status writeBoneMap(const std::string& path, const BoneMap& map, bool overwrite) {
    return writeFileAtomically(
        path, toJson(map).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n", overwrite);
}

Result<BoneMap> readBoneMap(const std::string& path) {
    const auto text = readWholeFile(path);
    if (!text)
        return text.error();
    return boneMapFromJson(json::parse(*text), path);
}

}  // namespace noctule
