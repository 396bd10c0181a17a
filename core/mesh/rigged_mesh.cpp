// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rigged_mesh.h"

#include <algorithm>

namespace noctule {
namespace {

Eigen::Affine3d placed(const Vector3d& p_m, const Quaterniond& q, const Vector3d& scale) {
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    T.linear() = q.toRotationMatrix() * scale.asDiagonal();
    T.translation() = p_m;
    return T;
}

Eigen::Affine3d trackAt(const RigTrack& track, double t_s) {
    const auto after = std::upper_bound(track.t_s.begin(), track.t_s.end(), t_s);
    if (after == track.t_s.begin())
        return placed(track.p_m.front(), track.q_parent_node.front(), track.scale.front());
    if (after == track.t_s.end())
        return placed(track.p_m.back(), track.q_parent_node.back(), track.scale.back());
    const size_t b = static_cast<size_t>(after - track.t_s.begin()), a = b - 1;
    const double f = (t_s - track.t_s[a]) / (track.t_s[b] - track.t_s[a]);
    return placed((1 - f) * track.p_m[a] + f * track.p_m[b],
                  track.q_parent_node[a].slerp(f, track.q_parent_node[b]),
                  (1 - f) * track.scale[a] + f * track.scale[b]);
}

}  // namespace

int RiggedMesh::find(const std::string& name) const {
    for (size_t n = 0; n < nodes.size(); ++n)
        if (nodes[n].name == name)
            return static_cast<int>(n);
    return -1;
}

RigPose restPose(const RiggedMesh& mesh) {
    RigPose pose;
    for (const RigNode& node : mesh.nodes)
        pose.push_back(node.T_world_rest);
    return pose;
}

RigPose posed(const RiggedMesh& mesh, const std::vector<Eigen::Affine3d>& T_parent_node) {
    require(T_parent_node.size() == mesh.nodes.size(), "posed() needs one transform per node");
    RigPose pose;
    for (size_t n = 0; n < mesh.nodes.size(); ++n) {
        const int parent = mesh.nodes[n].parent;
        pose.push_back(parent < 0 ? T_parent_node[n] : pose[static_cast<size_t>(parent)] * T_parent_node[n]);
    }
    return pose;
}

RigPose posed(const RiggedMesh& mesh, const RigClip& clip, double t_s) {
    std::vector<Eigen::Affine3d> local;
    for (const RigNode& node : mesh.nodes)
        local.push_back(node.T_parent_node);
    for (const RigTrack& track : clip.tracks)
        local[static_cast<size_t>(track.node)] = trackAt(track, t_s);
    return posed(mesh, local);
}

std::vector<Eigen::Matrix4f> skinMatrices(const RiggedMesh& mesh, const RigPose& pose) {
    require(pose.size() == mesh.nodes.size(), "skinMatrices() needs a transform per node");
    std::vector<Eigen::Matrix4f> matrices;
    for (size_t b = 0; b < mesh.skin.bones.size(); ++b) {
        const Eigen::Affine3d& T_world_node = pose[static_cast<size_t>(mesh.node_of_bone[b])];
        const Eigen::Matrix4d bind = mesh.skin.bones[b].bind_inverse.cast<double>();
        matrices.push_back((T_world_node.matrix() * bind).cast<float>());
    }
    return matrices;
}

SkinnedMesh standingSurface(const SkinnedMesh& skin) {
    SkinnedMesh surface = skin;
    surface.bones = {SkinBone{"Hips"}};
    for (SkinnedVertex& vertex : surface.vertices) {
        vertex.bones = {};
        vertex.weights = {1, 0, 0, 0};
    }
    return surface;
}

RiggedMesh withParts(const RiggedMesh& mesh, const std::vector<bool>& keep) {
    require(keep.size() == mesh.parts.size(), "withParts() needs a word for each part");
    std::vector<bool> triangles(mesh.skin.triangles.size(), false);
    std::vector<MeshPart> parts;
    uint32_t first = 0;
    for (size_t p = 0; p < keep.size(); ++p) {
        if (!keep[p])
            continue;
        const MeshPart& part = mesh.parts[p];
        std::fill_n(triangles.begin() + part.first_triangle, part.triangles, true);
        parts.push_back({part.name, first, part.triangles});
        first += part.triangles;
    }
    return {mesh.nodes,        onlyTriangles(mesh.skin, triangles),
            mesh.node_of_bone, std::move(parts),
            mesh.clips,        mesh.humanoid};
}

}  // namespace noctule
