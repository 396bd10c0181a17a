// SPDX-License-Identifier: Apache-2.0
// Which node of a rig plays which of our joints. Found by itself, by names and else by the shape of the tree;
// corrected by hand and kept as JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/body/bone_names.h"
#include "core/mesh/rigged_mesh.h"

namespace noctule {

struct BoneMap {
    std::map<std::string, std::string> node_of_joint;  ///< canonical joint name -> name of a node

    bool operator==(const BoneMap&) const = default;
};

/// Those of mainJoints() without a node.
std::vector<std::string> missingMainJoints(const BoneMap& map);

/// By the names of its nodes; see core/body/bone_names.h.
BoneMap mapByNames(const RiggedMesh& mesh);
/// By where the nodes of a body that stands upright branch and end, whatever they are called.
BoneMap mapByShape(const RiggedMesh& mesh);
/// As the file says (RiggedMesh::humanoid), else by names where they give all main joints, else by whichever
/// gives more.
BoneMap findBoneMap(const RiggedMesh& mesh);

/// kUnusable, by name: an unknown joint or node, a main joint without a node, a node that plays two joints or
/// does not hang below that of the joint's parent.
Status checkBoneMap(const BoneMap& map, const RiggedMesh& mesh, const std::string& where);

nlohmann::json toJson(const BoneMap& map);
/// kUnreadable when it is none; unknown members are ignored.
Result<BoneMap> boneMapFromJson(const nlohmann::json& json, const std::string& where);

/// kUsage and kDisk as writeFileAtomically().
Status writeBoneMap(const std::string& path, const BoneMap& map, bool overwrite);
Result<BoneMap> readBoneMap(const std::string& path);

}  // namespace noctule
