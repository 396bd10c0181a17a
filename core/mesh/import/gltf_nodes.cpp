// SPDX-License-Identifier: Apache-2.0
// Nodes and the humanoid table of VRM.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/body/bone_spelling.h"
#include "core/math/json.h"
#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

Eigen::Affine3d gltfLocal(const nlohmann::json& node) {
    const auto numbersOf = [&](const char* member, size_t count) {
        std::vector<double> numbers;
        for (const nlohmann::json& value : gltfMember(node, member))
            numbers.push_back(json::number(value).value_or(std::nan("")));
        return numbers.size() == count ? numbers : std::vector<double>();
    };
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    if (const auto m = numbersOf("matrix", 16); !m.empty()) {
        T.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix4d>(m.data()).topRows<3>();
        return T;
    }
    const auto t = numbersOf("translation", 3), r = numbersOf("rotation", 4), s = numbersOf("scale", 3);
    if (!t.empty())
        T.translation() = Vector3d(t[0], t[1], t[2]);
    if (!r.empty()) {
        const Quaterniond q(r[3], r[0], r[1], r[2]);
        if (q.norm() > 1e-9)
            T.linear() = q.normalized().toRotationMatrix();
    }
    if (!s.empty())
        T.linear() = T.linear() * Vector3d(s[0], s[1], s[2]).asDiagonal();
    return T;
}

std::set<size_t> gltfJoints(const GltfDocument& document) {
    std::set<size_t> joints;
    for (size_t s = 0; s < document.count("skins"); ++s)
        for (const nlohmann::json& joint : gltfMember(document.item("skins", s), "joints"))
            if (joint.is_number_unsigned())
                joints.insert(joint.get<size_t>());
    return joints;
}

/// Bones first, so that they keep their names.
void nameNodes(const GltfDocument& document, GltfNodes& nodes) {
    const std::set<size_t> joints = gltfJoints(document);
    std::set<std::string> taken;
    for (const bool are_joints : {true, false})
        for (size_t n = 0; n < nodes.names.size(); ++n) {
            if (joints.contains(n) != are_joints)
                continue;
            std::string name = json::text(document.item("nodes", n), "name").value_or("");
            if (name.empty())
                name = "node_" + std::to_string(n);
            nodes.names[n] = name;
            for (int number = 2; !taken.insert(nodes.names[n]).second; ++number)
                nodes.names[n] = name + "_" + std::to_string(number);
        }
}

Status linkNodes(const GltfDocument& document, GltfNodes& nodes) {
    for (size_t n = 0; n < nodes.names.size(); ++n)
        for (const nlohmann::json& child : gltfMember(document.item("nodes", n), "children")) {
            if (!child.is_number_unsigned() || !nodes.has(child.get<size_t>()))
                return document.damaged("node " + std::to_string(n) + " has a child that does not exist");
            const auto c = child.get<size_t>();
            if (nodes.parents[c] >= 0)
                return document.damaged("node " + nodes.names[c] + " hangs on two others");
            nodes.parents[c] = static_cast<int>(n);
            nodes.children[n].push_back(static_cast<int>(c));
        }
    for (size_t n = nodes.names.size(); n-- > 0;)
        if (nodes.parents[n] < 0)
            nodes.order.push_back(static_cast<int>(n));
    std::reverse(nodes.order.begin(), nodes.order.end());
    for (size_t i = 0; i < nodes.order.size(); ++i)
        for (const int child : nodes.children[static_cast<size_t>(nodes.order[i])])
            nodes.order.push_back(child);
    if (nodes.order.size() != nodes.names.size())
        return document.damaged("its nodes hang on each other in a circle");
    return Done{};
}

/// VRM's names of our joints. Of two the later one wins: the upper chest carries the arms.
constexpr struct {
    const char* vrm;
    JointRole role;
} kVrmRoles[] = {
    {"hips", JointRole::kHips},         {"spine", JointRole::kSpine},    {"chest", JointRole::kChest},
    {"upperChest", JointRole::kChest},  {"neck", JointRole::kNeck},      {"head", JointRole::kHead},
    {"Shoulder", JointRole::kShoulder}, {"UpperArm", JointRole::kArm},   {"LowerArm", JointRole::kForeArm},
    {"Hand", JointRole::kHand},         {"UpperLeg", JointRole::kUpLeg}, {"LowerLeg", JointRole::kLeg},
    {"Foot", JointRole::kFoot},         {"Toes", JointRole::kToeBase}};

/// VRM's bone -> node, of either version.
std::map<std::string, size_t> vrmBones(const nlohmann::json& extensions) {
    std::map<std::string, size_t> bones;
    const auto bonesOf = [&](const char* extension) -> const nlohmann::json& {
        return gltfMember(gltfMember(gltfMember(extensions, extension), "humanoid"), "humanBones");
    };
    if (const nlohmann::json& one = bonesOf("VRMC_vrm"); one.is_object())
        for (const auto& [bone, told] : one.items())
            if (const auto node = gltfIndex(told, "node"))
                bones[bone] = *node;
    for (const nlohmann::json& told : bonesOf("VRM"))
        if (const auto node = gltfIndex(told, "node"))
            if (const auto bone = json::text(told, "bone"))
                bones.try_emplace(*bone, *node);
    return bones;
}

}  // namespace

Result<GltfNodes> gltfNodes(const GltfDocument& document) {
    const size_t count = document.count("nodes");
    if (count > MeshLimits::kNodes)
        return document.damaged("it has more than " + std::to_string(MeshLimits::kNodes) + " nodes");
    GltfNodes nodes;
    nodes.names.resize(count);
    nodes.parents.assign(count, -1);
    nodes.children.resize(count);
    nameNodes(document, nodes);
    if (const Status linked = linkNodes(document, nodes); !linked)
        return linked.error();
    for (size_t n = 0; n < count; ++n)
        nodes.T_parent_node.push_back(gltfLocal(document.item("nodes", n)));
    nodes.T_file_node = nodes.T_parent_node;
    for (const int node : nodes.order)
        if (const int parent = nodes.parents[static_cast<size_t>(node)]; parent >= 0)
            nodes.T_file_node[static_cast<size_t>(node)] = nodes.T_file_node[static_cast<size_t>(parent)] *
                                                           nodes.T_parent_node[static_cast<size_t>(node)];
    return nodes;
}

std::map<std::string, std::string> gltfHumanoid(const GltfDocument& document, const GltfNodes& nodes) {
    const std::map<std::string, size_t> bones = vrmBones(gltfMember(document.json(), "extensions"));
    std::map<std::string, std::string> joints;
    const auto take = [&](const std::string& bone, JointRole role, BodySide side) {
        if (const auto found = bones.find(bone); found != bones.end() && nodes.has(found->second))
            joints[canonicalJoint(role, side)] = nodes.names[found->second];
    };
    for (const auto& [vrm, role] : kVrmRoles) {
        if (role < JointRole::kShoulder) {
            take(vrm, role, BodySide::kMiddle);
            continue;
        }
        take("left" + std::string(vrm), role, BodySide::kLeft);
        take("right" + std::string(vrm), role, BodySide::kRight);
    }
    return joints;
}

}  // namespace noctule
