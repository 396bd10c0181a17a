// SPDX-License-Identifier: Apache-2.0
#include "core/formats/glb_writer.h"

#include <assimp/anim.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Exporter.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/formats/figures_in_file.h"
#include "core/formats/glb_file.h"
#include "core/formats/scene_check.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

aiVector3D toAssimp(const Eigen::Vector3f& v) {
    return {v.x(), v.y(), v.z()};
}

aiMatrix4x4 toAssimp(const Eigen::Matrix4f& m) {
    return {m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3),
            m(2, 0), m(2, 1), m(2, 2), m(2, 3), 0,       0,       0,       1};
}

std::unique_ptr<aiBone> boneOf(const SkinnedMesh& mesh, size_t index) {
    std::vector<aiVertexWeight> weights;
    for (size_t v = 0; v < mesh.vertices.size(); ++v)
        if (const float weight = weightOn(mesh.vertices[v], index); weight > 0)
            weights.emplace_back(static_cast<unsigned>(v), weight);
    auto bone = std::make_unique<aiBone>();
    bone->mName = mesh.bones[index].joint;
    bone->mOffsetMatrix = toAssimp(mesh.bones[index].bind_inverse);
    bone->mNumWeights = static_cast<unsigned>(weights.size());
    bone->mWeights = new aiVertexWeight[weights.size()];
    std::copy(weights.begin(), weights.end(), bone->mWeights);
    return bone;
}

/// Whether vertices at one place hang on different bones, as those of clothes that lie on the skin.
bool hasLayers(const SkinnedMesh& mesh) {
    constexpr double kCell = 1e-4;
    for (const double shift : {0.0, 0.5}) {
        std::map<std::array<int64_t, 3>, const SkinnedVertex*> first_in_cell;
        for (const SkinnedVertex& vertex : mesh.vertices) {
            std::array<int64_t, 3> cell{};
            for (size_t axis = 0; axis < 3; ++axis)
                cell[axis] =
                    std::llround(static_cast<double>(vertex.p_m[static_cast<int>(axis)]) / kCell + shift);
            const SkinnedVertex& first = *first_in_cell.try_emplace(cell, &vertex).first->second;
            if (first.bones != vertex.bones || first.weights != vertex.weights)
                return true;
        }
    }
    return false;
}

/// Tilted by 0.01 degrees, in a direction that the bones give: the exporter makes one of vertices that are
/// alike in all but their bones, and clothes would hang on the body's.
Eigen::Vector3f ownNormal(const SkinnedVertex& vertex) {
    constexpr float kTilt = 2e-4F;
    uint32_t hash = 2166136261U;
    for (size_t i = 0; i < vertex.bones.size(); ++i)
        hash = ((hash ^ vertex.bones[i]) * 16777619U ^ static_cast<uint32_t>(vertex.weights[i] * 255)) *
               16777619U;
    const auto part = [&](unsigned shift) { return static_cast<float>(hash >> shift & 1023U) / 511.5F - 1; };
    return (vertex.normal + kTilt * Eigen::Vector3f(part(0), part(11), part(22))).normalized();
}

std::unique_ptr<aiMesh> meshOf(const std::string& name, const SkinnedMesh& mesh, bool is_textured,
                               unsigned material) {
    auto result = std::make_unique<aiMesh>();
    result->mName = name;
    result->mMaterialIndex = material;
    result->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    result->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
    result->mVertices = new aiVector3D[mesh.vertices.size()];
    result->mNormals = new aiVector3D[mesh.vertices.size()];
    const bool layered = hasLayers(mesh);
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
        result->mVertices[v] = toAssimp(mesh.vertices[v].p_m);
        result->mNormals[v] = toAssimp(layered ? ownNormal(mesh.vertices[v]) : mesh.vertices[v].normal);
    }
    if (is_textured) {
        result->mNumUVComponents[0] = 2;
        result->mTextureCoords[0] = new aiVector3D[mesh.vertices.size()];
        for (size_t v = 0; v < mesh.vertices.size(); ++v)
            result->mTextureCoords[0][v] = {mesh.vertices[v].uv.x(), mesh.vertices[v].uv.y(), 0};
    }
    result->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
    result->mFaces = new aiFace[mesh.triangles.size()];
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        result->mFaces[t].mNumIndices = 3;
        result->mFaces[t].mIndices = new unsigned[3];
        std::copy(mesh.triangles[t].begin(), mesh.triangles[t].end(), result->mFaces[t].mIndices);
    }
    result->mNumBones = static_cast<unsigned>(mesh.bones.size());
    result->mBones = new aiBone*[mesh.bones.size()];
    for (size_t b = 0; b < mesh.bones.size(); ++b)
        result->mBones[b] = boneOf(mesh, b).release();
    return result;
}

/// Nodes of the bones, under each other as in the skeleton; a bone without a joint there goes to the top.
/// Nodes stand where the bones were bound, which exporters and viewers take as the rest position.
void addBoneNodes(aiNode& top, const std::vector<SkinBone>& bones, const Skeleton& skeleton) {
    std::map<std::string, aiNode*> nodes;
    std::map<std::string, aiMatrix4x4> world_from_mesh;
    for (const SkinBone& bone : bones) {
        nodes[bone.joint] = new aiNode(bone.joint);
        world_from_mesh[bone.joint] = toAssimp(bone.bind_inverse);
    }
    for (const SkinBone& bone : bones) {
        const int joint = skeleton.find(bone.joint);
        const int parent = joint >= 0 ? skeleton.joint(joint).parent : -1;
        const auto found = parent >= 0 ? nodes.find(skeleton.joint(parent).name) : nodes.end();
        aiNode* node = nodes[bone.joint];
        node->mTransformation = world_from_mesh[bone.joint];
        node->mTransformation.Inverse();
        if (found != nodes.end())
            node->mTransformation = world_from_mesh[found->first] * node->mTransformation;
        aiNode* above = found != nodes.end() ? found->second : &top;
        above->addChildren(1, &node);
    }
}

std::unique_ptr<aiMaterial> skinMaterial(const SurfaceLook& look, std::optional<size_t> texture) {
    auto material = std::make_unique<aiMaterial>();
    const aiColor4D color(look.base_color.x(), look.base_color.y(), look.base_color.z(), 1);
    const float metallic = 0, roughness = 0.8F;
    material->AddProperty(&color, 1, AI_MATKEY_BASE_COLOR);
    if (texture) {
        const aiString embedded_one("*" + std::to_string(*texture));
        material->AddProperty(&embedded_one, AI_MATKEY_TEXTURE(aiTextureType_BASE_COLOR, 0));
    }
    material->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
    material->AddProperty(&roughness, 1, AI_MATKEY_ROUGHNESS_FACTOR);
    return material;
}

/// As it came, within the file.
std::unique_ptr<aiTexture> embedded(const SurfaceTexture& texture) {
    auto result = std::make_unique<aiTexture>();
    const size_t words = (texture.file.size() + sizeof(aiTexel) - 1) / sizeof(aiTexel);
    result->mWidth = static_cast<unsigned>(texture.file.size());
    result->pcData = new aiTexel[words];
    std::memcpy(static_cast<void*>(result->pcData), texture.file.data(), texture.file.size());
    std::strcpy(result->achFormatHint, textureEnding(texture).c_str());
    return result;
}

/// Keys stand in seconds. Neighbouring quaternions are on the same side, so that any reader turns the short
/// way.
std::unique_ptr<aiNodeAnim> channelOf(const MotionClip& clip, size_t joint) {
    const auto count = static_cast<unsigned>(clip.frames.size());
    auto channel = std::make_unique<aiNodeAnim>();
    channel->mNodeName = clip.skeleton.joints()[joint].name;
    channel->mNumRotationKeys = count;
    channel->mRotationKeys = new aiQuatKey[count];
    if (jointIsMoved(clip, joint)) {
        channel->mNumPositionKeys = count;
        channel->mPositionKeys = new aiVectorKey[count];
    }
    Quaterniond before = Quaterniond::Identity();
    for (unsigned f = 0; f < count; ++f) {
        const double time_s = f * clip.frame_time_s;
        Quaterniond q = clip.frames[f].q_parent_joint[joint].normalized();
        if (q.dot(before) < 0)
            q.coeffs() = -q.coeffs();
        before = q;
        const Eigen::Quaternionf single = q.cast<float>();
        channel->mRotationKeys[f] = {time_s, {single.w(), single.x(), single.y(), single.z()}};
        if (channel->mPositionKeys)
            channel->mPositionKeys[f] = {
                time_s, toAssimp(Eigen::Vector3f(localPosition_m(clip, f, joint).cast<float>()))};
    }
    return channel;
}

std::unique_ptr<aiAnimation> animationOf(const MotionClip& clip) {
    auto animation = std::make_unique<aiAnimation>();
    animation->mName = clip.name;
    animation->mTicksPerSecond = 1;
    animation->mDuration = clip.duration_s();
    animation->mNumChannels = static_cast<unsigned>(clip.skeleton.size());
    animation->mChannels = new aiNodeAnim*[animation->mNumChannels];
    for (unsigned j = 0; j < animation->mNumChannels; ++j)
        animation->mChannels[j] = channelOf(clip, j).release();
    return animation;
}

/// The triangles of one part and the vertices that they use.
SkinnedMesh meshOfPart(const SkinnedMesh& mesh, const SurfacePart& part) {
    std::vector<bool> keep(mesh.triangles.size(), false);
    std::fill_n(keep.begin() + part.first_triangle, part.triangles, true);
    return onlyTriangles(mesh, keep);
}

/// Each part of the surface is a mesh with a material of its own: the exporter makes primitives of those
/// that one node shows.
void addBody(aiScene& scene, const std::string& name, const SkinnedMesh& mesh) {
    const std::vector<SurfacePart> surface = surfaceParts(mesh);
    const auto textures = texturesOf(surface);
    const auto count = static_cast<unsigned>(surface.size());
    scene.mNumMaterials = scene.mNumMeshes = scene.mRootNode->mNumMeshes = count;
    scene.mMaterials = new aiMaterial*[count];
    scene.mMeshes = new aiMesh*[count];
    scene.mRootNode->mMeshes = new unsigned[count];
    for (unsigned p = 0; p < count; ++p) {
        const SurfacePart& part = surface[p];
        const auto texture = textureIndex(part, textures);
        scene.mMaterials[p] = skinMaterial(part.look.value_or(SurfaceLook()), texture).release();
        const aiString material(surfaceName(p));
        scene.mMaterials[p]->AddProperty(&material, AI_MATKEY_NAME);
        const SkinnedMesh own = count == 1 ? mesh : meshOfPart(mesh, part);
        scene.mMeshes[p] = meshOf(name, own, texture.has_value(), p).release();
        scene.mRootNode->mMeshes[p] = p;
    }
    scene.mNumTextures = static_cast<unsigned>(textures.size());
    scene.mTextures = textures.empty() ? nullptr : new aiTexture*[textures.size()];
    for (size_t t = 0; t < textures.size(); ++t)
        scene.mTextures[t] = embedded(*textures[t]).release();
}

/// The skinned mesh hangs on the root node itself: glTF wants skinned meshes at the root.
std::unique_ptr<aiScene> sceneOf(const SkinnedMesh* mesh, const Figure& figure) {
    const MotionClip& clip = figure.clip;
    auto scene = std::make_unique<aiScene>();
    scene->mRootNode = new aiNode(figure.character.empty() ? nameBesideJoints(clip.skeleton, "Mannequin")
                                                           : figure.character);
    if (mesh)
        addBody(*scene, bodyName(figure), *mesh);
    addBoneNodes(*scene->mRootNode, mesh ? mesh->bones : bonesOf(clip.skeleton), clip.skeleton);
    if (!clip.frames.empty()) {
        scene->mNumAnimations = 1;
        scene->mAnimations = new aiAnimation* [1] { animationOf(clip).release() };
    }
    return scene;
}

/// Gives nodes the places that the exporter leaves out: assimp 5.2.5 takes what differs from the identity by
/// less than 0.01, such as a vertebra of 8 mm, for the identity.
void placeNodes(nlohmann::json& nodes, const aiNode& node) {
    for (nlohmann::json& told : nodes)
        if (told.value("name", "") == node.mName.C_Str() && !told.contains("matrix") &&
            !told.contains("translation") && node.mTransformation != aiMatrix4x4()) {
            aiVector3D scale, place;
            aiQuaternion turn;
            node.mTransformation.Decompose(scale, turn, place);
            told["translation"] = {place.x, place.y, place.z};
            told["rotation"] = {turn.x, turn.y, turn.z, turn.w};
        }
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        placeNodes(nodes, *node.mChildren[c]);
}

/// kInternal when assimp refuses the scene; `where` names the file.
Result<GlbFile> exported(const std::string& where, const aiScene& scene) {
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, "glb2");
    if (!blob)
        return Error{ErrorKind::kInternal,
                     where + ": the figure cannot be written as glTF: " + exporter.GetErrorString(),
                     "Report this with the take"};
    GlbFile file = GlbFile::of({static_cast<const char*>(blob->data), blob->size});
    placeNodes(file.document["nodes"], *scene.mRootNode);
    return file;
}

Status writeFile(const std::string& path, Result<std::string> bytes, bool overwrite,
                 const AsideCheck& check) {
    if (!bytes)
        return bytes.error();
    const WrittenBytes written(*bytes);
    return writeFileAtomically(path, *bytes, overwrite, [&](const std::string& aside) {
        *bytes = {};  // they stand on the disk, and reading them back takes memory of its own
        const Status kept = written.check(aside, path);
        return kept && check ? check(aside) : kept;
    });
}

/// Figure after figure in one file.
class GlbCollector {
public:
    explicit GlbCollector(const std::string& where) : where_(where), shared_(where) {}

    Status add(const Figure& figure) {
        if (const Status fits = shared_.add(figure); !fits)
            return fits;
        const bool shows_body = figure.body && (!file_ || !figure.character.empty());
        auto own = exported(where_, *sceneOf(shows_body ? &*figure.body : nullptr, figure));
        if (!own)
            return own.error();
        if (!file_)
            file_ = std::move(*own);
        else if (figure.character.empty())
            file_->addAnimations(std::move(*own));
        else
            file_->addScene(std::move(*own));
        return Done{};
    }
    /// Once, after the last figure; there must have been one.
    Result<std::string> bytes() {
        const GlbFile file = std::move(file_.value());
        return file.bytes(where_);
    }

private:
    const std::string& where_;
    FiguresInFile shared_;
    std::optional<GlbFile> file_;
};

}  // namespace

Status writeGlb(const std::string& path, const FigureSource& figures, bool overwrite, const JobContext& job) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    GlbCollector collector(path);
    const Status collected = figures([&](const Figure& figure) -> Status {
        return job.cancelled() ? JobContext::cancelledError() : collector.add(figure);
    });
    if (!collected)
        return collected;
    return writeFile(path, collector.bytes(), overwrite, [&](const std::string& aside) {
        return checkScene(aside, path, SceneFormat::kGlb, figures, job);
    });
}

Status writeSkinnedMesh(const std::string& path, const SkinnedMesh& mesh, const Skeleton& skeleton,
                        bool overwrite) {
    Figure still;
    still.clip.skeleton = skeleton;
    const auto file = exported(path, *sceneOf(&mesh, still));
    return file ? writeFile(path, file->bytes(path), overwrite, {}) : Status(file.error());
}

}  // namespace noctule
