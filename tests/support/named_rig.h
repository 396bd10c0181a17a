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

}  // namespace noctule::test
