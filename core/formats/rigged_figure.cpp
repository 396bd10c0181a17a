// SPDX-License-Identifier: Apache-2.0
#include "core/formats/rigged_figure.h"

#include <algorithm>
#include <set>

#include "core/body/joint_names.h"
#include "core/math/rotation_fit.h"
#include "core/mesh/retarget/moving_body.h"
#include "core/mesh/rig/rig_tree.h"
#include "core/mesh/skinning.h"

namespace noctule {
namespace {

/// The nodes that become joints: the hips first, parents before children.
struct ChosenNodes {
    std::vector<int> nodes;
    std::vector<int> joint_of_node;  ///< -1: none

    explicit ChosenNodes(const WearableBody& body) : joint_of_node(body.mesh.nodes.size(), -1) {
        const RiggedMesh& mesh = body.mesh;
        const int hips = mesh.find(body.bones.node_of_joint.at("Hips"));
        std::vector<bool> wanted = movesSkin(mesh), holds_skin(mesh.nodes.size(), false);
        for (const int node : mesh.node_of_bone)
            holds_skin[static_cast<size_t>(node)] = true;
        for (const auto& [joint, name] : body.bones.node_of_joint)
            for (int node = mesh.find(name); node > hips; node = mesh.nodes[static_cast<size_t>(node)].parent)
                wanted[static_cast<size_t>(node)] = true;
        add(hips);
        for (size_t n = 0; n < mesh.nodes.size(); ++n) {
            const int node = static_cast<int>(n);
            if (node != hips && (hangsOn(mesh, node, hips) ? wanted[n] : holds_skin[n]))
                add(node);
        }
    }

    /// Of the nearest joint above; the hips' where there is none.
    int parentOf(const RiggedMesh& mesh, int node) const {
        do
            node = mesh.nodes[static_cast<size_t>(node)].parent;
        while (node >= 0 && joint_of_node[static_cast<size_t>(node)] < 0);
        return node < 0 ? 0 : std::max(0, joint_of_node[static_cast<size_t>(node)]);
    }

private:
    void add(int node) {
        joint_of_node[static_cast<size_t>(node)] = static_cast<int>(nodes.size());
        nodes.push_back(node);
    }
};

class RiggedFigure {
public:
    RiggedFigure(const WearableBody& body, const Retargeter& retargeter)
        : body_(body), mesh_(body.mesh), chosen_(body), retargeter_(retargeter) {
        for (const int node : chosen_.nodes) {
            const Eigen::Affine3d& T = mesh_.nodes[static_cast<size_t>(node)].T_world_rest;
            Eigen::Isometry3d rest = Eigen::Isometry3d::Identity();
            rest.linear() = retargeter.upright() * nearestRotation(T.linear());
            rest.translation() = retargeter.upright() * T.translation();
            rest_.push_back(rest);
        }
    }

    Result<Skeleton> skeleton(const Skeleton& performer, JointNames names) const {
        std::vector<Joint> joints(rest_.size());
        std::set<std::string> taken;
        for (size_t j = 0; j < joints.size(); ++j) {
            joints[j].name = freeName(nameOf(chosen_.nodes[j], performer, names), taken);
            joints[j].type = j == 0 ? JointType::kFree : JointType::kFixed;
            joints[j].parent = parent(j);
            if (j > 0)
                joints[j].offset_m = local(rest_, j).translation();
        }
        return Skeleton::make(std::move(joints));
    }

    Pose rest() const { return poseOf(rest_); }

    /// Other bodies in the file keep their place in the world, so their joints move under the hips.
    bool movesPlaces() const {
        return std::any_of(chosen_.nodes.begin(), chosen_.nodes.end(),
                           [&](int node) { return retargeter_.stands(node); });
    }

    std::vector<Eigen::Isometry3d> frames(const Pose& source, const FootCorrections& feet) const {
        const std::vector<Eigen::Isometry3d> motions = retargeter_.motions(source, feet);
        const Eigen::Isometry3d lying(Matrix3d(retargeter_.upright().transpose()));
        std::vector<Eigen::Isometry3d> frames;
        for (size_t j = 0; j < rest_.size(); ++j)
            frames.push_back(motions[static_cast<size_t>(chosen_.nodes[j])] * lying * rest_[j]);
        return frames;
    }

    void addFrame(const std::vector<Eigen::Isometry3d>& frames, MotionClip& clip) const {
        clip.frames.push_back(poseOf(frames));
        if (!movesPlaces())
            return;
        std::vector<Vector3d>& places_m = clip.p_parent_joint_m.emplace_back();
        for (size_t j = 0; j < frames.size(); ++j)
            places_m.emplace_back(local(frames, j).translation());
    }

    /// In the rest pose, one bone per joint.
    SkinnedMesh skin(const Skeleton& skeleton) const {
        SkinnedMesh skin = mesh_.skin;
        const Eigen::Matrix3f upright = retargeter_.upright().cast<float>();
        const PosedSurface rest = skinned(mesh_.skin, skinMatrices(mesh_, restPose(mesh_)));
        for (size_t v = 0; v < skin.vertices.size(); ++v) {
            SkinnedVertex& vertex = skin.vertices[v];
            vertex.p_m = upright * rest.points_m[v];
            vertex.normal = upright * rest.normals[v];
            for (size_t i = 0; i < vertex.bones.size(); ++i)
                vertex.bones[i] = vertex.weights[i] > 0 ? jointOfBone(vertex.bones[i]) : uint16_t{0};
        }
        skin.bones.clear();
        for (size_t j = 0; j < rest_.size(); ++j)
            skin.bones.push_back({skeleton.joints()[j].name, rest_[j].inverse().matrix().cast<float>()});
        return skin;
    }

    /// Per joint that of ours which turns it or one above it.
    std::vector<size_t> sourceJoints(const Skeleton& performer) const {
        constexpr size_t kNone = SIZE_MAX;
        std::vector<size_t> sources(rest_.size(), kNone);
        for (const auto& [joint, name] : body_.bones.node_of_joint)
            if (const int source = findByAnyName(performer, joint); source >= 0)
                sources[static_cast<size_t>(chosen_.joint_of_node[static_cast<size_t>(mesh_.find(name))])] =
                    static_cast<size_t>(source);
        for (size_t j = 1; j < sources.size(); ++j)
            if (sources[j] == kNone)
                sources[j] = sources[static_cast<size_t>(parent(j))];
        return sources;
    }

private:
    int parent(size_t joint) const { return joint == 0 ? -1 : chosen_.parentOf(mesh_, chosen_.nodes[joint]); }

    Eigen::Isometry3d local(const std::vector<Eigen::Isometry3d>& frames, size_t joint) const {
        return joint == 0 ? frames[0] : frames[static_cast<size_t>(parent(joint))].inverse() * frames[joint];
    }

    Pose poseOf(const std::vector<Eigen::Isometry3d>& frames) const {
        Pose pose;
        pose.p_world_root = frames[0].translation();
        for (size_t j = 0; j < frames.size(); ++j)
            pose.q_parent_joint.push_back(Quaterniond(local(frames, j).linear()).normalized());
        return pose;
    }

    uint16_t jointOfBone(uint16_t bone) const {
        const auto node = static_cast<size_t>(mesh_.node_of_bone[bone]);
        return static_cast<uint16_t>(std::max(0, chosen_.joint_of_node[node]));
    }

    std::string nameOf(int node, const Skeleton& performer, JointNames names) const {
        const std::string& name = mesh_.nodes[static_cast<size_t>(node)].name;
        const int joint = body_.landmarks ? performer.find(name) : -1;
        return joint >= 0 ? exportedName(performer.joint(joint), names) : name.empty() ? "bone" : name;
    }

    static std::string freeName(const std::string& name, std::set<std::string>& taken) {
        std::string free = name;
        for (int number = 2; !taken.insert(free).second; ++number)
            free = name + "_" + std::to_string(number);
        return free;
    }

    const WearableBody& body_;
    const RiggedMesh& mesh_;
    ChosenNodes chosen_;
    const Retargeter& retargeter_;
    std::vector<Eigen::Isometry3d> rest_;  ///< per joint, world
};

}  // namespace

Result<Figure> riggedFigure(const MotionClip& clip, const std::vector<std::vector<float>>& confidence,
                            const WearableBody& body, JointNames names, const FeetAtRest& at_rest,
                            const std::vector<FootCorrections>& feet) {
    if (const Status finite = checkFinite(clip); !finite)
        return finite.error();
    const auto retargeter =
        Retargeter::make(body.mesh, bonesFor(body.bones, clip.skeleton), clip.skeleton, at_rest, body.name);
    if (!retargeter)
        return retargeter.error();
    const RiggedFigure rigged(body, *retargeter);
    auto skeleton = rigged.skeleton(clip.skeleton, names);
    if (!skeleton)
        return skeleton.error();
    Figure figure;
    figure.clip.name = clip.name;
    figure.clip.frame_time_s = clip.frame_time_s;
    for (size_t f = 0; f < clip.frames.size(); ++f)
        rigged.addFrame(rigged.frames(clip.frames[f], feet.empty() ? FootCorrections() : feet[f]),
                        figure.clip);
    figure.body = rigged.skin(*skeleton);
    figure.rest = rigged.rest();
    figure.clip.skeleton = std::move(*skeleton);
    const std::vector<size_t> sources = rigged.sourceJoints(clip.skeleton);
    for (const std::vector<float>& row : confidence) {
        figure.confidence.emplace_back();
        for (const size_t source : sources)
            figure.confidence.back().push_back(row[source]);
    }
    return figure;
}

std::map<std::string, int> figureJoints(const WearableBody& body) {
    const ChosenNodes chosen(body);
    std::map<std::string, int> joints;
    for (const auto& [joint, name] : body.bones.node_of_joint)
        joints[joint] = chosen.joint_of_node[static_cast<size_t>(body.mesh.find(name))];
    return joints;
}

MotionClip restParallel(const MotionClip& clip, const std::vector<Quaterniond>& q_world_rest) {
    MotionClip turned = clip;
    std::vector<Joint> joints = clip.skeleton.joints();
    const auto above = [&](size_t j) {
        return joints[j].parent < 0 ? Quaterniond::Identity()
                                    : q_world_rest[static_cast<size_t>(joints[j].parent)];
    };
    for (size_t j = 0; j < joints.size(); ++j) {
        joints[j].offset_m = above(j) * joints[j].offset_m;
        for (Pose& pose : turned.frames)
            pose.q_parent_joint[j] = above(j) * pose.q_parent_joint[j] * q_world_rest[j].conjugate();
        for (auto& places_m : turned.p_parent_joint_m)
            places_m[j] = above(j) * places_m[j];
    }
    turned.skeleton = Skeleton::make(std::move(joints)).value();
    return turned;
}

}  // namespace noctule
