// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/import/glb_reader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/body/actor.h"

namespace noctule {
namespace {

Eigen::Vector3f toFloats(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// Builds one mesh of the file's meshes; the first trouble ends it.
class SkinCollector {
public:
    SkinCollector(const aiScene& scene, const std::string& path) : scene_(scene), path_(path) {}

    Result<SkinnedMesh> collect() {
        for (unsigned m = 0; m < scene_.mNumMeshes; ++m)
            if (scene_.mMeshes[m]->HasBones())
                if (const Status added = addMesh(*scene_.mMeshes[m]); !added)
                    return added.error();
        if (!unknown_.empty())
            return unknownBones();
        if (mesh_.vertices.empty())
            return Error{ErrorKind::kUnusable, path_ + ": no mesh in it has a skin",
                         "Export the body together with its armature and skin weights"};
        return std::move(mesh_);
    }

private:
    Error damaged(const std::string& what) const {
        return {ErrorKind::kUnreadable, path_ + ": " + what, "Export the mesh again; the file is damaged"};
    }

    Error unknownBones() const {
        constexpr size_t kNamed = 5;
        std::string names;
        for (size_t i = 0; i < std::min(kNamed, unknown_.size()); ++i)
            names += (i ? ", " : "") + unknown_[i];
        if (unknown_.size() > kNamed)
            names += " and " + std::to_string(unknown_.size() - kNamed) + " more";
        return {ErrorKind::kUnusable, path_ + ": bones belong to no joint: " + names,
                "Name the bones as HumanIK or Mixamo do: Hips, Spine, LeftArm, LeftForeArm"};
    }

    /// The joint of a bone's node or of the nearest node above it; empty when there is none.
    std::string jointOf(const aiString& bone) const {
        for (const aiNode* node = scene_.mRootNode->FindNode(bone); node; node = node->mParent)
            if (const std::string joint = canonicalJointOf(node->mName.C_Str()); !joint.empty())
                return joint;
        return canonicalJointOf(bone.C_Str());
    }

    /// Index of the bone for a joint. A bone of its own name places it; a finer one only until then.
    uint16_t boneFor(const std::string& joint, const aiBone& bone) {
        const bool own = canonicalJointOf(bone.mName.C_Str()) == joint;
        const auto [entry, is_new] = bone_of_joint_.try_emplace(joint, mesh_.bones.size());
        if (is_new)
            mesh_.bones.push_back({joint});
        if (is_new || own) {
            aiMatrix4x4 bind = bone.mOffsetMatrix;
            bind.Inverse();
            mesh_.bones[entry->second].bind_inverse.topRightCorner<3, 1>() =
                -Eigen::Vector3f(bind.a4, bind.b4, bind.c4);
        }
        return static_cast<uint16_t>(entry->second);
    }

    Status addMesh(const aiMesh& part) {
        std::vector<std::map<uint16_t, float>> weights(part.mNumVertices);
        for (unsigned b = 0; b < part.mNumBones; ++b) {
            const aiBone& bone = *part.mBones[b];
            const std::string joint = jointOf(bone.mName);
            if (joint.empty()) {
                unknown_.emplace_back(bone.mName.C_Str());
                continue;
            }
            const uint16_t index = boneFor(joint, bone);
            for (unsigned w = 0; w < bone.mNumWeights; ++w) {
                if (bone.mWeights[w].mVertexId >= part.mNumVertices)
                    return damaged("bone " + joint + " weighs a vertex that does not exist");
                weights[bone.mWeights[w].mVertexId][index] += bone.mWeights[w].mWeight;
            }
        }
        const uint32_t first = static_cast<uint32_t>(mesh_.vertices.size());
        for (unsigned v = 0; v < part.mNumVertices; ++v)
            if (const Status added = addVertex(part, v, weights[v]); !added)
                return added;
        return addTriangles(part, first);
    }

    Status addVertex(const aiMesh& part, unsigned v, const std::map<uint16_t, float>& weights) {
        std::vector<std::pair<uint16_t, float>> heaviest(weights.begin(), weights.end());
        std::stable_sort(heaviest.begin(), heaviest.end(),
                         [](const auto& a, const auto& b) { return a.second > b.second; });
        heaviest.resize(std::min<size_t>(4, heaviest.size()));
        float sum = 0;
        for (const auto& [bone, weight] : heaviest)
            sum += weight;
        SkinnedVertex vertex{toFloats(part.mVertices[v]), toFloats(part.mNormals[v]).normalized(), {}, {}};
        if (!vertex.p_m.allFinite() || !vertex.normal.allFinite() || !std::isfinite(sum))
            return damaged("vertex " + std::to_string(v) + " holds something that is no number");
        if (!(sum > 0) && unknown_.empty())
            return Error{ErrorKind::kUnusable, path_ + ": vertex " + std::to_string(v) + " hangs on no bone",
                         "Give every vertex of the skin a weight"};
        for (size_t i = 0; i < heaviest.size(); ++i) {
            vertex.bones[i] = heaviest[i].first;
            vertex.weights[i] = heaviest[i].second / sum;
        }
        mesh_.vertices.push_back(vertex);
        return Done{};
    }

    Status addTriangles(const aiMesh& part, uint32_t first) {
        for (unsigned f = 0; f < part.mNumFaces; ++f) {
            const aiFace& face = part.mFaces[f];
            if (face.mNumIndices != 3)
                continue;  // loose points and lines
            for (unsigned i = 0; i < 3; ++i)
                if (face.mIndices[i] >= part.mNumVertices)
                    return damaged("triangle " + std::to_string(f) + " uses a vertex that does not exist");
            mesh_.triangles.push_back(
                {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
        }
        return Done{};
    }

    const aiScene& scene_;
    const std::string& path_;
    SkinnedMesh mesh_;
    std::map<std::string, size_t> bone_of_joint_;
    std::vector<std::string> unknown_;
};

std::map<std::string, std::string> jointOfKnownName() {
    std::map<std::string, std::string> joints;
    const Skeleton skeleton = defaultActor().skeleton;
    for (const Joint& joint : skeleton.joints()) {
        joints[joint.name] = joint.name;
        for (const auto& [program, alias] : joint.aliases)
            joints[alias.substr(alias.rfind(':') + 1)] = joint.name;
    }
    return joints;
}

}  // namespace

std::string meshReaderVersion() {
    return std::to_string(aiGetVersionMajor()) + "." + std::to_string(aiGetVersionMinor()) + "." +
           std::to_string(aiGetVersionPatch());
}

std::string canonicalJointOf(const std::string& bone) {
    static const std::map<std::string, std::string> joints = jointOfKnownName();
    const auto found = joints.find(bone.substr(bone.rfind(':') + 1));  // npos + 1 is 0: no prefix
    return found == joints.end() ? std::string() : found->second;
}

Result<SkinnedMesh> readSkinnedMesh(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        return Error{ErrorKind::kUnreadable, path + ": there is no such file", "Choose a .glb or .gltf file"};
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_GenSmoothNormals);
    if (!scene || !scene->mRootNode)
        return Error{ErrorKind::kUnreadable,
                     path + ": this is no mesh that can be read (" + importer.GetErrorString() + ")",
                     "Export the body as binary glTF (.glb)"};
    return SkinCollector(*scene, path).collect();
}

}  // namespace noctule
