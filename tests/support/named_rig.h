// SPDX-License-Identifier: Apache-2.0
// The default body's joints as a rig of another program: other names, another rest pose, other proportions.
#pragma once

#include <functional>

#include "core/body/actor.h"
#include "core/mesh/rigged_mesh.h"

namespace noctule::test {

/// Nodes only. `name` gives a joint's name there; a joint whose name is empty is left out, its children hang
/// on its parent. The rest pose is `rest`, lengths are multiplied by `size`; every node's frame is turned by
/// `q_node`, as other programs turn theirs along the bone.
inline RiggedMesh namedRig(
    const std::function<std::string(const std::string&)>& name,
    const std::function<Quaterniond(const std::string&)>& rest =
        [](const std::string&) { return Quaterniond::Identity(); },
    double size = 1, const Quaterniond& q_node = Quaterniond::Identity()) {
    const Skeleton skeleton = defaultActor().skeleton;
    Pose pose = skeleton.zeroPose();
    for (int j = 0; j < skeleton.size(); ++j)
        pose.q_parent_joint[static_cast<size_t>(j)] = rest(skeleton.joint(j).name);
    pose.p_world_root.y() = 0.98;
    const GlobalPose global = globalPose(skeleton, pose);
    RiggedMesh rig;
    rig.nodes.push_back({"Armature", -1});
    std::vector<int> node_of_joint;
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        int parent = joint.parent < 0 ? 0 : node_of_joint[static_cast<size_t>(joint.parent)];
        const std::string called = name(joint.name);
        if (called.empty()) {
            node_of_joint.push_back(parent);
            continue;
        }
        RigNode node{called, parent};
        node.T_world_rest.linear() =
            (global.q_world_joint[static_cast<size_t>(j)] * q_node).toRotationMatrix();
        node.T_world_rest.translation() = size * global.p_world_joint[static_cast<size_t>(j)];
        node.T_parent_node =
            rig.nodes[static_cast<size_t>(parent)].T_world_rest.inverse() * node.T_world_rest;
        node_of_joint.push_back(static_cast<int>(rig.nodes.size()));
        rig.nodes.push_back(node);
    }
    return rig;
}

/// Gives every node but the first a triangle at its place, half of whose corners hang on the parent's bone
/// too.
inline void giveSkin(RiggedMesh& rig) {
    for (size_t n = 1; n < rig.nodes.size(); ++n) {
        const RigNode& node = rig.nodes[n];
        rig.skin.bones.push_back({node.name, node.T_world_rest.inverse().matrix().cast<float>()});
        rig.node_of_bone.push_back(static_cast<int>(n));
        const auto first = static_cast<uint32_t>(rig.skin.vertices.size());
        const auto own = static_cast<uint16_t>(n - 1);
        const auto above = static_cast<uint16_t>(std::max(0, node.parent - 1));
        for (const Eigen::Vector3f& off : {Eigen::Vector3f(0, 0, 0.05F), {0.04F, 0, 0}, {0, 0.03F, 0}}) {
            SkinnedVertex vertex;
            vertex.p_m = node.T_world_rest.translation().cast<float>() + off;
            vertex.bones = {own, above, 0, 0};
            vertex.weights = {off.x() > 0 ? 0.5F : 1, off.x() > 0 ? 0.5F : 0, 0, 0};
            rig.skin.vertices.push_back(vertex);
        }
        rig.skin.triangles.push_back({first, first + 1, first + 2});
    }
    rig.parts.push_back({"skin", 0, static_cast<uint32_t>(rig.skin.triangles.size())});
}

}  // namespace noctule::test
