// SPDX-License-Identifier: Apache-2.0
#include "core/formats/scene_reader.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>

#include "core/formats/figure.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

constexpr double kTimeOff_frames = 0.05;  ///< a key may be off; glTF's times are float32
constexpr int kYAxis = 1;

Eigen::Matrix4d toEigen(const aiMatrix4x4& m) {
    Eigen::Matrix4f result;
    result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return result.cast<double>();
}

Vector3d toVector(const aiVector3D& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Quaterniond toQuaternion(const aiQuaternion& q) {
    return Eigen::Quaternionf(q.w, q.x, q.y, q.z).normalized().cast<double>();
}

/// The first below `above` of that name: what stands at the very top is the file's or the library's own, and
/// may be called like a joint.
const aiNode* findBelow(const aiNode& above, const std::string& name) {
    for (unsigned c = 0; c < above.mNumChildren; ++c)
        if (const aiNode* found = above.mChildren[c]->FindNode(name.c_str()))
            return found;
    return nullptr;
}

class SceneReader {
public:
    SceneReader(const aiScene& scene, const std::string& where) : scene_(scene), where_(where) {}

    Result<SceneMotion> read(const std::vector<std::string>& joints, const std::string& motion) {
        if (const Status chosen = chooseMotion(motion); !chosen)
            return chosen.error();
        for (Status (SceneReader::*step)(const std::vector<std::string>&) :
             {&SceneReader::readUnit, &SceneReader::readJoints, &SceneReader::readChannels,
              &SceneReader::readFrames, &SceneReader::readSkin})
            if (Status done = (this->*step)(joints); !done)
                return done.error();
        return std::move(motion_);
    }

private:
    Error odd(const std::string& what) const {
        return {ErrorKind::kUnreadable, where_ + ": " + what, "Write the file again"};
    }

    /// Whether the bone belongs to another character than the joints asked for.
    static bool isAnothers(std::string_view bone, const std::vector<std::string>& names) {
        const std::string_view own = characterOf(names.front());
        return !own.empty() && !characterOf(bone).empty() && characterOf(bone) != own;
    }

    /// One without a name is any.
    Status chooseMotion(const std::string& name) {
        for (unsigned a = 0; a < scene_.mNumAnimations && !animation_; ++a) {
            const std::string called = scene_.mAnimations[a]->mName.C_Str();
            if (name.empty() || called.empty() || called == name)
                animation_ = scene_.mAnimations[a];
        }
        const bool is_still = scene_.mNumAnimations == 0;
        return animation_ || is_still ? Status(Done{}) : Status(odd("no motion in it is called " + name));
    }

    /// FBX says both; glTF is in metres with Y up.
    Status readUnit(const std::vector<std::string>&) {
        float units_cm = 100;
        int up = kYAxis;
        if (scene_.mMetaData) {
            scene_.mMetaData->Get("UnitScaleFactor", units_cm);
            scene_.mMetaData->Get("UpAxis", up);
        }
        metres_per_unit_ = static_cast<double>(units_cm) / 100;
        return up == kYAxis ? Status(Done{}) : Status(odd("Y is not up in it"));
    }

    /// Each hangs directly on its parent; above the first there may be nodes that stand still.
    Status readJoints(const std::vector<std::string>& names) {
        std::map<const aiNode*, int> joint_of;
        std::vector<Joint> joints;
        for (const std::string& name : names) {
            const aiNode* node = findBelow(*scene_.mRootNode, name);
            if (!node)
                return odd("joint " + name + " is missing");
            Joint joint;
            joint.name = name;
            joint.type = joints.empty() ? JointType::kFree : JointType::kFixed;
            if (!joints.empty()) {
                const auto parent = joint_of.find(node->mParent);
                if (parent == joint_of.end())
                    return odd("joint " + name + " hangs on no joint");
                joint.parent = parent->second;
                joint.offset_m = toEigen(node->mTransformation).topRightCorner<3, 1>() * metres_per_unit_;
            }
            joint_of[node] = static_cast<int>(joints.size());
            nodes_.push_back(node);
            joints.push_back(joint);
        }
        for (const aiNode* node = nodes_[0]->mParent; node; node = node->mParent)
            above_ = toEigen(node->mTransformation) * above_;
        auto skeleton = Skeleton::make(std::move(joints));
        if (!skeleton)
            return skeleton.error();
        motion_.clip.skeleton = std::move(*skeleton);
        return Done{};
    }

    Status readChannels(const std::vector<std::string>& names) {
        channels_.assign(names.size(), nullptr);
        if (!animation_)
            return Done{};
        const aiAnimation& animation = *animation_;
        motion_.clip.name = animation.mName.C_Str();
        for (unsigned c = 0; c < animation.mNumChannels; ++c) {
            const aiNodeAnim& channel = *animation.mChannels[c];
            const auto name = std::find(names.begin(), names.end(), channel.mNodeName.C_Str());
            if (name == names.end() && isAnothers(channel.mNodeName.C_Str(), names))
                continue;
            if (name == names.end())
                return odd("a motion belongs to " + std::string(channel.mNodeName.C_Str()) +
                           ", which is no joint");
            channels_[static_cast<size_t>(name - names.begin())] = &channel;
            for (const Status& keys : {checkKeys(channel.mPositionKeys, channel.mNumPositionKeys),
                                       checkKeys(channel.mRotationKeys, channel.mNumRotationKeys)})
                if (!keys)
                    return keys;
        }
        return Done{};
    }

    /// One key per frame at equal steps from time 0; or a single one for all.
    template <class Key>
    Status checkKeys(const Key* keys, unsigned count) {
        if (count <= 1)
            return Done{};
        if (frames_ > 1 && count != frames_)
            return odd("one joint has " + std::to_string(count) + " frames, another " +
                       std::to_string(frames_));
        const double step = keys[count - 1].mTime / (count - 1);
        for (unsigned k = 0; k < count; ++k)
            if (std::abs(keys[k].mTime / step - k) > kTimeOff_frames)
                return odd("frame " + std::to_string(k + 1) + " stands at another time");
        frames_ = count;
        motion_.clip.frame_time_s = step / animation_->mTicksPerSecond;
        return Done{};
    }

    Status readFrames(const std::vector<std::string>&) {
        for (size_t f = 0; f < frames_; ++f) {
            Pose pose;
            std::vector<Vector3d> places_m;
            for (size_t j = 0; j < nodes_.size(); ++j) {
                Eigen::Matrix4d local = localAt(j, f);
                if (j == 0)
                    local = above_ * local;
                places_m.push_back(local.topRightCorner<3, 1>() * metres_per_unit_);
                pose.q_parent_joint.push_back(Quaterniond(Matrix3d(local.topLeftCorner<3, 3>())));
            }
            pose.p_world_root = places_m[0];
            motion_.clip.frames.push_back(std::move(pose));
            motion_.clip.p_parent_joint_m.push_back(std::move(places_m));
        }
        return Done{};
    }

    Eigen::Matrix4d localAt(size_t joint, size_t frame) const {
        Eigen::Matrix4d local = toEigen(nodes_[joint]->mTransformation);
        const aiNodeAnim* channel = channels_[joint];
        if (channel && channel->mNumRotationKeys > 0)
            local.topLeftCorner<3, 3>() =
                toQuaternion(channel->mRotationKeys[channel->mNumRotationKeys > 1 ? frame : 0].mValue)
                    .toRotationMatrix();
        if (channel && channel->mNumPositionKeys > 0)
            local.topRightCorner<3, 1>() =
                toVector(channel->mPositionKeys[channel->mNumPositionKeys > 1 ? frame : 0].mValue);
        return local;
    }

    Status readSkin(const std::vector<std::string>& names) {
        motion_.bind_inverse.assign(names.size(), Eigen::Matrix4d::Identity());
        for (unsigned m = 0; m < scene_.mNumMeshes; ++m)
            if (const aiMesh& mesh = *scene_.mMeshes[m];
                mesh.HasBones() && !isAnothers(mesh.mBones[0]->mName.C_Str(), names))
                if (const Status part = readSkinPart(*scene_.mMeshes[m], names); !part)
                    return part;
        return Done{};
    }

    Status readSkinPart(const aiMesh& mesh, const std::vector<std::string>& names) {
        const size_t first = motion_.corners.size();
        motion_.corners.resize(first + mesh.mNumVertices);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            motion_.corners[first + v].p_m = toVector(mesh.mVertices[v]) * metres_per_unit_;
        for (unsigned v = 0; mesh.mTextureCoords[0] && v < mesh.mNumVertices; ++v)
            motion_.corners[first + v].uv = {mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y};
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const aiBone& bone = *mesh.mBones[b];
            const auto name = std::find(names.begin(), names.end(), bone.mName.C_Str());
            if (name == names.end())
                return odd("its skin hangs on " + std::string(bone.mName.C_Str()) + ", which is no joint");
            const auto joint = static_cast<size_t>(name - names.begin());
            motion_.bind_inverse[joint] = toEigen(bone.mOffsetMatrix);
            motion_.bind_inverse[joint].topRightCorner<3, 1>() *= metres_per_unit_;
            for (unsigned w = 0; w < bone.mNumWeights; ++w)
                motion_.corners.at(first + bone.mWeights[w].mVertexId)
                    .weights.emplace_back(joint, static_cast<double>(bone.mWeights[w].mWeight));
        }
        SceneMaterial material = mesh.mMaterialIndex < scene_.mNumMaterials
                                     ? materialOf(*scene_.mMaterials[mesh.mMaterialIndex])
                                     : SceneMaterial();
        const size_t faces = motion_.faces.size();
        const auto corner = [&](unsigned index) { return static_cast<uint32_t>(first + index); };
        for (unsigned t = 0; t < mesh.mNumFaces; ++t)
            if (const aiFace& face = mesh.mFaces[t]; face.mNumIndices == 3)
                motion_.faces.push_back(
                    {corner(face.mIndices[0]), corner(face.mIndices[1]), corner(face.mIndices[2])});
        material.faces = motion_.faces.size() - faces;
        motion_.materials.push_back(std::move(material));
        return Done{};
    }

    SceneMaterial materialOf(const aiMaterial& material) const {
        SceneMaterial read;
        aiColor4D color;
        if (material.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS ||
            material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
            read.base_color = {color.r, color.g, color.b};
        aiString named;
        for (const aiTextureType kind : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE})
            if (material.GetTexture(kind, 0, &named) == AI_SUCCESS)
                if (const aiTexture* picture = scene_.GetEmbeddedTexture(named.C_Str());
                    picture && picture->mHeight == 0)
                    read.texture.assign(reinterpret_cast<const char*>(picture->pcData), picture->mWidth);
        return read;
    }

    const aiScene& scene_;
    const std::string& where_;
    const aiAnimation* animation_ = nullptr;  ///< nullptr: the file holds none
    double metres_per_unit_ = 1;
    std::vector<const aiNode*> nodes_;         ///< per joint
    std::vector<const aiNodeAnim*> channels_;  ///< per joint; nullptr: stands still
    Eigen::Matrix4d above_ = Eigen::Matrix4d::Identity();
    unsigned frames_ = 1;
    SceneMotion motion_;
};

}  // namespace

std::vector<Vector3d> SceneMotion::skinned_m(size_t frame) const {
    const GlobalPose pose = globalPose(clip, frame);
    std::vector<Eigen::Matrix4d> matrices;
    for (size_t j = 0; j < bind_inverse.size(); ++j) {
        Eigen::Matrix4d world = Eigen::Matrix4d::Identity();
        world.topLeftCorner<3, 3>() = pose.q_world_joint[j].toRotationMatrix();
        world.topRightCorner<3, 1>() = pose.p_world_joint[j];
        matrices.push_back(world * bind_inverse[j]);
    }
    std::vector<Vector3d> points_m;
    for (const SceneCorner& corner : corners) {
        Eigen::Vector4d point = Eigen::Vector4d::Zero();
        for (const auto& [joint, weight] : corner.weights)
            point += weight * (matrices[joint] * corner.p_m.homogeneous());
        points_m.emplace_back(point.head<3>());
    }
    return points_m;
}

SceneFile::SceneFile(std::unique_ptr<Assimp::Importer> importer, std::string where)
    : importer_(std::move(importer)), where_(std::move(where)) {}
SceneFile::SceneFile(SceneFile&&) noexcept = default;
SceneFile& SceneFile::operator=(SceneFile&&) noexcept = default;
SceneFile::~SceneFile() = default;

Result<SceneFile> SceneFile::open(const std::string& path, const std::string& where, SceneFormat format) {
    const auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    auto importer = std::make_unique<Assimp::Importer>();
    const aiScene* scene = importer->ReadFileFromMemory(bytes->data(), bytes->size(), 0,
                                                        format == SceneFormat::kFbx ? "fbx" : "glb");
    if (!scene || !scene->mRootNode)
        return Error{ErrorKind::kUnreadable,
                     where + ": it cannot be read again (" + importer->GetErrorString() + ")",
                     "Write the file again"};
    return SceneFile(std::move(importer), where);
}

Result<SceneMotion> SceneFile::read(const std::vector<std::string>& joints, const std::string& motion) const {
    return SceneReader(*importer_->GetScene(), where_).read(joints, motion);
}

}  // namespace noctule
