// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/auto_rig.h"

#include <algorithm>

#include "core/body/actor.h"
#include "core/mesh/surface_graph.h"

namespace noctule {
namespace {

constexpr float kLeastWeight = 0.01F;  ///< what weighs less is dropped

/// From each joint to its children, and to the tips. The pelvis and the shoulders' girdle are warmed by the
/// lines to the limbs as well; clavicles are too short to be warmed by anything else.
std::vector<BoneLine> boneLines(const Skeleton& skeleton, const Landmarks& landmarks) {
    std::vector<BoneLine> lines;
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        if (joint.parent >= 0)
            lines.push_back(
                {joint.parent, landmarks.at(skeleton.joint(joint.parent).name), landmarks.at(joint.name)});
        if (const auto tip = landmarks.find(joint.name + "End"); tip != landmarks.end())
            lines.push_back({j, landmarks.at(joint.name), tip->second});
    }
    return lines;
}

void putNodes(RiggedMesh& mesh, const Skeleton& skeleton, const Landmarks& landmarks) {
    mesh.nodes.clear();
    mesh.skin.bones.clear();
    mesh.node_of_bone.clear();
    mesh.clips.clear();
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const Vector3d p = landmarks.at(joint.name);
        RigNode node{joint.name, joint.parent};
        node.T_world_rest = Eigen::Translation3d(p);
        node.T_parent_node =
            Eigen::Translation3d(joint.parent < 0 ? p : p - landmarks.at(skeleton.joint(joint.parent).name));
        mesh.nodes.push_back(node);
        mesh.skin.bones.push_back({joint.name, node.T_world_rest.inverse().matrix().cast<float>()});
        mesh.node_of_bone.push_back(j);
    }
}

void giveHeatWeights(SkinnedVertex& vertex, const Eigen::MatrixXd& weights, Eigen::Index point) {
    std::vector<std::pair<float, uint16_t>> heaviest;
    for (Eigen::Index b = 0; b < weights.cols(); ++b)
        heaviest.emplace_back(static_cast<float>(weights(point, b)), static_cast<uint16_t>(b));
    std::sort(heaviest.begin(), heaviest.end(),
              [](const auto& a, const auto& b) { return a.first > b.first; });
    vertex.bones = {};
    vertex.weights = {};
    float sum = 0;
    for (size_t i = 0; i < vertex.weights.size(); ++i)
        if (heaviest[i].first > kLeastWeight)
            sum += heaviest[i].first;
    for (size_t i = 0; i < vertex.weights.size() && heaviest[i].first > kLeastWeight; ++i) {
        vertex.bones[i] = heaviest[i].second;
        vertex.weights[i] = heaviest[i].first / sum;
    }
}

}  // namespace

Result<RiggedMesh> autoRigged(const RiggedMesh& figure, const Landmarks& landmarks, const std::string& where,
                              const HeatSettings& settings, const JobContext& job) {
    for (const std::string& name : landmarkNames())
        if (const auto found = landmarks.find(name); found == landmarks.end() || !found->second.allFinite())
            return Error{ErrorKind::kUsage, where + ": " + name + " has no place",
                         "Set all joints of the body"};
    static const Skeleton skeleton = defaultActor().skeleton;
    const WeldedSurface surface = welded(figure.skin);
    const auto weights =
        heatWeights(surface.mesh, boneLines(skeleton, landmarks), skeleton.size(), settings, job);
    if (!weights) {
        Error error = weights.error();
        if (error.kind != ErrorKind::kCancelled)
            error.message = where + ": " + error.message;
        return error;
    }
    RiggedMesh mesh = figure;
    putNodes(mesh, skeleton, landmarks);
    for (size_t v = 0; v < mesh.skin.vertices.size(); ++v)
        giveHeatWeights(mesh.skin.vertices[v], *weights, static_cast<Eigen::Index>(surface.point_of[v]));
    return mesh;
}

}  // namespace noctule
