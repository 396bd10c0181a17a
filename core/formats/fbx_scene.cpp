// SPDX-License-Identifier: Apache-2.0
#include "core/formats/fbx_scene.h"

#include <cmath>

#include "core/math/euler.h"

namespace noctule {
namespace {

constexpr double kFbxTicksPerSecond = 46186158000.0;

/// A node of the tree. Inheritance 1: a parent's scale goes along with its rotation, as everywhere else.
std::vector<FbxNode> fbxModel(const Vector3d& p, const Quaterniond& q, std::vector<FbxNode> more) {
    const Vector3d angles_rad = eulerFromRotation(kFbxOrder, q);
    Vector3d turn_deg = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        turn_deg[kFbxOrder[static_cast<size_t>(i)]] = degrees(angles_rad[i]);
    std::vector<FbxNode> entries{
        fbxProperty("InheritType", "enum", "", "", int32_t{1}),
        fbxProperty("Lcl Translation", "Lcl Translation", "", "A", p.x(), p.y(), p.z()),
        fbxProperty("Lcl Rotation", "Lcl Rotation", "", "A", turn_deg.x(), turn_deg.y(), turn_deg.z()),
        fbxProperty("Lcl Scaling", "Lcl Scaling", "", "A", 1.0, 1.0, 1.0)};
    entries.insert(entries.end(), more.begin(), more.end());
    return {FbxNode("Version", int32_t{232}), fbxProperties(entries), FbxNode("Shading", true),
            FbxNode("Culling", "CullingOff")};
}

int64_t addFbxBone(FbxScene& scene, const std::string& name, const std::vector<FbxNode>& model) {
    const int64_t bone = scene.add("Model", name, "Model", "LimbNode", model);
    scene.connect(scene.add("NodeAttribute", name, "NodeAttribute", "LimbNode",
                            {fbxProperties({fbxProperty("Size", "double", "Number", "", 1.0)}),
                             FbxNode("TypeFlags", "Skeleton")}),
                  bone);
    return bone;
}

int64_t addFbxTop(FbxScene& scene, const std::string& name) {
    const auto model = fbxModel(Vector3d::Zero(), Quaterniond::Identity(), {});
    const int64_t top = scene.add("Model", name, "Model", "Null", model);
    scene.connect(scene.add("NodeAttribute", name, "NodeAttribute", "Null", {FbxNode("TypeFlags", "Null")}),
                  top);
    return top;
}

}  // namespace

int64_t FbxScene::add(const std::string& kind, const std::string& name, const std::string& of_class,
                      const std::string& type, const std::vector<FbxNode>& content) {
    FbxNode object(kind, next_, fbxObjectName(name, of_class), type);
    for (const FbxNode& node : content)
        object.add(node);
    objects_.add(std::move(object));
    ++counts_[kind];
    return next_++;
}

void FbxScene::connect(int64_t child, int64_t parent) {
    connections_.add(FbxNode("C", "OO", child, parent));
}

void FbxScene::connect(int64_t child, int64_t parent, const std::string& property) {
    connections_.add(FbxNode("C", "OP", child, parent, property));
}

FbxNode FbxScene::definitions() const {
    int32_t total = 1;
    for (const auto& [kind, count] : counts_)
        total += count;
    FbxNode node("Definitions");
    node.add(FbxNode("Version", int32_t{100})).add(FbxNode("Count", total));
    const auto add = [&](const std::string& kind, int32_t count) {
        node.add(std::move(FbxNode("ObjectType", kind).add(FbxNode("Count", count))));
    };
    add("GlobalSettings", 1);
    for (const auto& [kind, count] : counts_)
        add(kind, count);
    return node;
}

FbxNode fbxProperties(const std::vector<FbxNode>& entries) {
    FbxNode list("Properties70");
    for (const FbxNode& entry : entries)
        list.add(entry);
    return list;
}

int64_t fbxTime(double seconds) {
    return std::llround(seconds * kFbxTicksPerSecond);
}

int64_t fbxTime(const MotionClip& clip, size_t frame) {
    return fbxTime(static_cast<double>(frame) * clip.frame_time_s);
}

int64_t fbxLastTime(const MotionClip& clip) {
    return clip.frames.empty() ? 0 : fbxTime(clip, clip.frames.size() - 1);
}

std::vector<int64_t> addFbxSkeleton(FbxScene& scene, const Figure& figure, const FbxOptions& options) {
    const Skeleton& skeleton = figure.clip.skeleton;
    std::vector<int64_t> models{addFbxTop(
        scene, nameBesideJoints(skeleton, figure.character.empty() ? options.root_name : figure.character))};
    scene.connect(models[0], FbxScene::kTop);
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const Vector3d p_m = j == 0 ? figure.rest.p_world_root : joint.offset_m;
        const Quaterniond& q = figure.rest.q_parent_joint[static_cast<size_t>(j)];
        std::vector<FbxNode> more;
        if (!figure.confidence.empty())
            more.push_back(fbxProperty("confidence", "Number", "", "A+U", 1.0));
        const int64_t bone = addFbxBone(scene, joint.name, fbxModel(p_m / options.metres_per_unit, q, more));
        scene.connect(bone, models[static_cast<size_t>(joint.parent + 1)]);
        models.push_back(bone);
    }
    return models;
}

}  // namespace noctule
