// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/other_skeletons.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/rig/rig_tree.h"

namespace noctule {
namespace {

constexpr size_t kSkeleton = 6;           ///< joints with known names that make a skeleton
constexpr double kSamePlace_legs = 0.15;  ///< of a leg: how far joints of clothes are from those of the body

/// A tree of nodes beside that of the hips.
struct Branch {
    int top = 0;
    std::vector<bool> nodes;              ///< per node of the mesh
    std::map<std::string, int> of_joint;  ///< by names
};

class OtherSkeletons {
public:
    OtherSkeletons(const RiggedMesh& mesh, const BoneMap& map)
        : mesh_(mesh), map_(map), moves_(movesSkin(mesh)) {
        const auto hips = map.node_of_joint.find("Hips");
        hips_ = hips == map.node_of_joint.end() ? -1 : mesh.find(hips->second);
        for (size_t n = 0; hips_ >= 0 && n < mesh.nodes.size(); ++n) {
            const int node = static_cast<int>(n), parent = mesh.nodes[n].parent;
            const bool is_above_hips = hangsOn(mesh, hips_, node);
            const bool is_top = parent < 0 || hangsOn(mesh, hips_, parent);
            if (!is_above_hips && is_top && moves_[n] && !hangsOn(mesh, node, hips_))
                addBranch(node);
        }
    }

    const std::vector<Branch>& branches() const { return branches_; }

    bool isDress(const Branch& branch) const {
        const auto shared = sharedJoints(branch);
        double squares = 0;
        for (const auto& [joint, node] : shared)
            squares += (placeOf(node) - placeOf(ours(joint))).squaredNorm();
        return shared.size() >= 2 &&
               std::sqrt(squares / static_cast<double>(shared.size())) < kSamePlace_legs * legLength();
    }

    bool isBody(const Branch& branch) const {
        if (isDress(branch))
            return false;
        return branch.of_joint.size() >= kSkeleton || (hasManyBones(branch) && liesBeside(branch));
    }

    /// Joints that both have.
    std::map<std::string, int> sharedJoints(const Branch& branch) const {
        std::map<std::string, int> shared;
        for (const auto& [joint, node] : branch.of_joint)
            if (ours(joint) >= 0)
                shared[joint] = node;
        return shared;
    }

    int ours(const std::string& joint) const {
        const auto found = map_.node_of_joint.find(joint);
        return found == map_.node_of_joint.end() ? -1 : mesh_.find(found->second);
    }

private:
    void addBranch(int top) {
        Branch branch{top, std::vector<bool>(mesh_.nodes.size(), false), {}};
        std::vector<NamedBone> bones;
        std::vector<int> node_of;
        std::vector<int> bone_of(mesh_.nodes.size(), -1);
        for (size_t n = static_cast<size_t>(top); n < mesh_.nodes.size(); ++n) {
            const int node = static_cast<int>(n), parent = mesh_.nodes[n].parent;
            branch.nodes[n] = node == top || (parent >= 0 && branch.nodes[static_cast<size_t>(parent)]);
            if (!branch.nodes[n])
                continue;
            bone_of[n] = static_cast<int>(bones.size());
            bones.push_back(
                {mesh_.nodes[n].name, node == top ? -1 : bone_of[static_cast<size_t>(parent)], moves_[n]});
            node_of.push_back(node);
        }
        for (const auto& [joint, bone] : jointsByName(bones).bone_of_joint)
            branch.of_joint[joint] = node_of[static_cast<size_t>(bone)];
        branches_.push_back(std::move(branch));
    }

    Vector3d placeOf(int node) const {
        return mesh_.nodes[static_cast<size_t>(node)].T_world_rest.translation();
    }

    double legLength() const {
        const int hip = ours("LeftUpLeg"), knee = ours("LeftLeg"), ankle = ours("LeftFoot");
        return hip < 0 || knee < 0 || ankle < 0
                   ? 0
                   : (placeOf(hip) - placeOf(knee)).norm() + (placeOf(knee) - placeOf(ankle)).norm();
    }

    bool hasManyBones(const Branch& branch) const {
        constexpr std::ptrdiff_t kMany = 12;
        std::ptrdiff_t moving = 0;
        for (size_t n = 0; n < branch.nodes.size(); ++n)
            moving += branch.nodes[n] && moves_[n];
        return moving >= kMany;
    }

    /// Its skin's middle is outside of the box around ours, seen from above.
    bool liesBeside(const Branch& branch) const {
        Eigen::AlignedBox2f own, other;
        for (const SkinnedVertex& vertex : mesh_.skin.vertices) {
            const auto node = static_cast<size_t>(mesh_.node_of_bone[vertex.bones[0]]);
            (branch.nodes[node] ? other : own).extend(Eigen::Vector2f(vertex.p_m.x(), vertex.p_m.z()));
        }
        return !own.isEmpty() && !other.isEmpty() && !own.contains(other.center());
    }

    const RiggedMesh& mesh_;
    const BoneMap& map_;
    std::vector<bool> moves_;
    int hips_ = -1;
    std::vector<Branch> branches_;
};

/// Parents first again, after nodes were hung elsewhere.
RiggedMesh parentsFirst(RiggedMesh mesh) {
    const auto children = childrenOf(mesh);
    std::vector<int> order, place(mesh.nodes.size());
    for (size_t n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].parent < 0)
            order.push_back(static_cast<int>(n));
    for (size_t i = 0; i < order.size(); ++i)
        for (const int child : children[static_cast<size_t>(order[i])])
            order.push_back(child);
    std::vector<RigNode> nodes;
    for (size_t i = 0; i < order.size(); ++i) {
        place[static_cast<size_t>(order[i])] = static_cast<int>(i);
        RigNode& node = nodes.emplace_back(std::move(mesh.nodes[static_cast<size_t>(order[i])]));
        node.parent = node.parent < 0 ? -1 : place[static_cast<size_t>(node.parent)];
    }
    mesh.nodes = std::move(nodes);
    for (int& node : mesh.node_of_bone)
        node = place[static_cast<size_t>(node)];
    for (RigClip& clip : mesh.clips)
        for (RigTrack& track : clip.tracks)
            track.node = place[static_cast<size_t>(track.node)];
    return mesh;
}

/// Bones of the clothes' joint are ours from now on, and its other children hang on ours.
void putOn(RiggedMesh& mesh, int joint, int ours) {
    const Eigen::Affine3d T_ours_joint = mesh.nodes[static_cast<size_t>(ours)].T_world_rest.inverse() *
                                         mesh.nodes[static_cast<size_t>(joint)].T_world_rest;
    for (size_t b = 0; b < mesh.node_of_bone.size(); ++b)
        if (mesh.node_of_bone[b] == joint) {
            mesh.node_of_bone[b] = ours;
            mesh.skin.bones[b].joint = mesh.nodes[static_cast<size_t>(ours)].name;
            mesh.skin.bones[b].bind_inverse =
                T_ours_joint.matrix().cast<float>() * mesh.skin.bones[b].bind_inverse;
        }
    for (RigNode& node : mesh.nodes)
        if (node.parent == joint) {
            node.parent = ours;
            node.T_parent_node = T_ours_joint * node.T_parent_node;
        }
}

}  // namespace

std::vector<bool> nodesOfOtherBodies(const RiggedMesh& mesh, const BoneMap& map) {
    std::vector<bool> others(mesh.nodes.size(), false);
    const OtherSkeletons skeletons(mesh, map);
    for (const Branch& branch : skeletons.branches())
        if (skeletons.isBody(branch))
            for (size_t n = 0; n < others.size(); ++n)
                others[n] = others[n] || branch.nodes[n];
    return others;
}

RiggedMesh dressed(RiggedMesh mesh, const BoneMap& map) {
    std::vector<std::pair<int, int>> joints;  // of clothes, and ours
    std::vector<bool> moved(mesh.nodes.size(), false);
    {
        const OtherSkeletons skeletons(mesh, map);
        for (const Branch& branch : skeletons.branches()) {
            if (!skeletons.isDress(branch))
                continue;
            for (const auto& [joint, node] : skeletons.sharedJoints(branch))
                joints.emplace_back(node, skeletons.ours(joint));
            for (size_t n = 0; n < moved.size(); ++n)
                moved[n] = moved[n] || branch.nodes[n];
        }
    }
    if (joints.empty())
        return mesh;
    for (RigClip& clip : mesh.clips)  // they move the clothes below other nodes than these
        std::erase_if(clip.tracks,
                      [&](const RigTrack& track) { return moved[static_cast<size_t>(track.node)]; });
    for (const auto& [joint, ours] : joints)
        putOn(mesh, joint, ours);
    return parentsFirst(std::move(mesh));
}

}  // namespace noctule
