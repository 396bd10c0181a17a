// SPDX-License-Identifier: Apache-2.0
#include "core/formats/scene_check.h"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>

#include "core/job/atomic_file.h"
#include "core/mesh/skinning.h"

namespace noctule {
namespace {

constexpr size_t kSkinFrames = 8;         ///< in which the skin is compared
constexpr double kTimeOff_frames = 0.05;  ///< a key may be off; glTF's times are float32

Eigen::Matrix4d toEigen(const aiMatrix4x4& m) {
    Eigen::Matrix4f result;
    result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return result.cast<double>();
}

Vector3d toVector(const aiVector3D& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

class SceneComparison {
public:
    SceneComparison(const aiScene& scene, const Figure& figure, const std::string& where,
                    double metres_per_unit)
        : scene_(scene), figure_(figure), where_(where), metres_per_unit_(metres_per_unit) {}

    Result<SceneDifference> run() {
        collect(*scene_.mRootNode, -1);
        for (const Joint& joint : figure_.clip.skeleton.joints()) {
            const auto found = node_of_.find(joint.name);
            if (found == node_of_.end())
                return odd("joint " + joint.name + " is missing");
            joints_.push_back(found->second);
        }
        if (Status animated = readAnimation(); !animated)
            return animated.error();
        if (Status skinned_well = readSkin(); !skinned_well)
            return skinned_well.error();
        const size_t frames = figure_.clip.frames.size(), step = std::max<size_t>(1, frames / kSkinFrames);
        for (size_t f = 0; f < frames; ++f) {
            pose(f);
            compareJoints(f);
            if (figure_.body && f % step == 0)
                compareSkin(f);
        }
        return difference_;
    }

private:
    struct Node {
        const aiNode* node;
        int parent;
        const aiNodeAnim* channel = nullptr;
        Eigen::Matrix4d world = Eigen::Matrix4d::Identity();
    };
    struct Weight {
        size_t node;
        Eigen::Matrix4d bind_inverse;
        double weight;
    };

    Error odd(const std::string& what) const {
        return {ErrorKind::kUnreadable, where_ + ": " + what, "Write the file again"};
    }

    void collect(const aiNode& node, int parent) {
        const int index = static_cast<int>(nodes_.size());
        node_of_.emplace(node.mName.C_Str(), nodes_.size());
        nodes_.push_back({&node, parent});
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            collect(*node.mChildren[c], index);
    }

    Status readAnimation() {
        difference_.frames = figure_.clip.frames.empty() ? 0 : 1;
        if (figure_.clip.frames.empty() || scene_.mNumAnimations == 0)
            return Done{};
        const aiAnimation& animation = *scene_.mAnimations[0];
        if (animation.mName.C_Str() != figure_.clip.name)
            return odd("its motion is called " + std::string(animation.mName.C_Str()));
        for (unsigned c = 0; c < animation.mNumChannels; ++c) {
            const aiNodeAnim& channel = *animation.mChannels[c];
            const auto found = node_of_.find(channel.mNodeName.C_Str());
            if (found == node_of_.end())
                return odd("a motion belongs to " + std::string(channel.mNodeName.C_Str()) +
                           ", which is not there");
            nodes_[found->second].channel = &channel;
            const double ticks = animation.mTicksPerSecond;
            for (const Status& keys : {checkKeys(channel.mPositionKeys, channel.mNumPositionKeys, ticks),
                                       checkKeys(channel.mRotationKeys, channel.mNumRotationKeys, ticks)})
                if (!keys)
                    return keys;
        }
        return Done{};
    }

    /// One key per frame, where the frame is; or a single one for all.
    template <class Key>
    Status checkKeys(const Key* keys, unsigned count, double ticks_per_second) {
        if (count <= 1)
            return Done{};
        if (count != figure_.clip.frames.size())
            return odd("it holds " + std::to_string(count) + " frames instead of " +
                       std::to_string(figure_.clip.frames.size()));
        const double step_s = figure_.clip.frame_time_s;
        for (unsigned k = 0; k < count; ++k)
            if (std::abs(keys[k].mTime / ticks_per_second / step_s - k) > kTimeOff_frames)
                return odd("frame " + std::to_string(k + 1) + " stands at another time");
        difference_.frames = count;
        difference_.frames_per_second =
            (count - 1) * ticks_per_second / (keys[count - 1].mTime - keys[0].mTime);
        return Done{};
    }

    Status readSkin() {
        if (!figure_.body)
            return Done{};
        for (unsigned m = 0; m < scene_.mNumMeshes && !mesh_; ++m)
            if (scene_.mMeshes[m]->HasBones())
                mesh_ = scene_.mMeshes[m];
        if (!mesh_ || mesh_->mNumFaces != figure_.body->triangles.size())
            return odd("its body has " + std::to_string(mesh_ ? mesh_->mNumFaces : 0) +
                       " triangles instead of " + std::to_string(figure_.body->triangles.size()));
        weights_.resize(mesh_->mNumVertices);
        for (unsigned b = 0; b < mesh_->mNumBones; ++b) {
            const aiBone& bone = *mesh_->mBones[b];
            const auto found = node_of_.find(bone.mName.C_Str());
            if (found == node_of_.end())
                return odd("its skin hangs on " + std::string(bone.mName.C_Str()) + ", which is not there");
            for (unsigned w = 0; w < bone.mNumWeights; ++w)
                weights_.at(bone.mWeights[w].mVertexId)
                    .push_back({found->second, toEigen(bone.mOffsetMatrix),
                                static_cast<double>(bone.mWeights[w].mWeight)});
        }
        return Done{};
    }

    void pose(size_t frame) {
        for (Node& node : nodes_) {
            Eigen::Matrix4d local = toEigen(node.node->mTransformation);
            if (const aiNodeAnim* channel = node.channel) {
                if (channel->mNumRotationKeys > 0) {
                    const size_t key = channel->mNumRotationKeys > 1 ? frame : 0;
                    const aiQuaternion& q = channel->mRotationKeys[key].mValue;
                    local.topLeftCorner<3, 3>() =
                        Eigen::Quaternionf(q.w, q.x, q.y, q.z).normalized().cast<double>().toRotationMatrix();
                }
                if (channel->mNumPositionKeys > 0)
                    local.topRightCorner<3, 1>() =
                        toVector(channel->mPositionKeys[channel->mNumPositionKeys > 1 ? frame : 0].mValue);
            }
            node.world = node.parent < 0
                             ? local
                             : Eigen::Matrix4d(nodes_[static_cast<size_t>(node.parent)].world * local);
        }
    }

    void compareJoints(size_t frame) {
        const GlobalPose expected = globalPose(figure_.clip, frame);
        for (size_t j = 0; j < joints_.size(); ++j) {
            const Vector3d p_m = nodes_[joints_[j]].world.topRightCorner<3, 1>() * metres_per_unit_;
            difference_.joint_m = std::max(difference_.joint_m, (p_m - expected.p_world_joint[j]).norm());
        }
    }

    /// Readers may give every triangle its own corners; so the triangles are compared, corner by corner.
    void compareSkin(size_t frame) {
        const SkinnedMesh& body = *figure_.body;
        const auto expected =
            skinned(body, skinMatrices(body, figure_.clip.skeleton, globalPose(figure_.clip, frame)));
        std::vector<Vector3d> points_m(weights_.size(), Vector3d::Zero());
        for (size_t v = 0; v < weights_.size(); ++v) {
            const Eigen::Vector4d bound = toVector(mesh_->mVertices[v]).homogeneous();
            for (const Weight& w : weights_[v])
                points_m[v] +=
                    w.weight * metres_per_unit_ * (nodes_[w.node].world * (w.bind_inverse * bound)).head<3>();
        }
        for (unsigned t = 0; t < mesh_->mNumFaces; ++t)
            for (unsigned i = 0; i < std::min(3U, mesh_->mFaces[t].mNumIndices); ++i)
                difference_.vertex_m =
                    std::max(difference_.vertex_m, (points_m[mesh_->mFaces[t].mIndices[i]] -
                                                    expected.points_m[body.triangles[t][i]].cast<double>())
                                                       .norm());
    }

    const aiScene& scene_;
    const Figure& figure_;
    const std::string& where_;
    double metres_per_unit_;
    std::vector<Node> nodes_;  ///< parents first
    std::map<std::string, size_t> node_of_;
    std::vector<size_t> joints_;
    const aiMesh* mesh_ = nullptr;
    std::vector<std::vector<Weight>> weights_;  ///< per corner of the file's mesh
    SceneDifference difference_;
};

}  // namespace

Result<SceneDifference> compareScene(const std::string& path, const std::string& where, SceneFormat format,
                                     const Figure& figure, double metres_per_unit) {
    const auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes->data(), bytes->size(), 0,
                                                       format == SceneFormat::kFbx ? "fbx" : "glb");
    if (!scene || !scene->mRootNode)
        return Error{ErrorKind::kUnreadable,
                     where + ": it cannot be read again (" + importer.GetErrorString() + ")",
                     "Write the file again"};
    return SceneComparison(*scene, figure, where, metres_per_unit).run();
}

Status checkScene(const std::string& path, const std::string& where, SceneFormat format, const Figure& figure,
                  double metres_per_unit) {
    const auto difference = compareScene(path, where, format, figure, metres_per_unit);
    if (difference && difference->joint_m <= kSceneLimit_m && difference->vertex_m <= kSceneLimit_m)
        return Done{};
    return Error{ErrorKind::kDisk,
                 where + ": what was written does not read back the same" +
                     (difference ? "" : " (" + difference.error().message + ")"),
                 "Check the disk and try again"};
}

}  // namespace noctule
