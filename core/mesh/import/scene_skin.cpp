// SPDX-License-Identifier: Apache-2.0
// Surfaces and how they hang on nodes.
#include <algorithm>
#include <cmath>

#include "core/mesh/import/scene_import.h"

namespace noctule {
namespace {

struct Influence {
    uint16_t bone;
    float weight;
};

/// The four heaviest, normalised; all zero without any.
void giveWeights(SkinnedVertex& vertex, std::vector<Influence>& influences) {
    std::stable_sort(influences.begin(), influences.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    influences.resize(std::min(influences.size(), vertex.bones.size()));
    float sum = 0;
    for (const Influence& influence : influences)
        sum += influence.weight;
    for (size_t i = 0; i < influences.size(); ++i) {
        vertex.bones[i] = influences[i].bone;
        vertex.weights[i] = influences[i].weight / sum;
    }
}

/// One object of the file where one node shows it.
struct ShownObject {
    int node;
    unsigned object;
};

Eigen::Affine3d placeOf(const SceneImport& import, const ShownObject& shown) {
    const auto placed = import.T_file_object.find(shown.object);
    return placed != import.T_file_object.end() ? placed->second
                                                : import.T_file_node[static_cast<size_t>(shown.node)];
}

/// Adds one object of the file, with its bones.
class ObjectImport {
public:
    ObjectImport(SceneImport& import, const ShownObject& shown, const std::optional<SurfaceLook>& look)
        : import_(import),
          object_(*import.scene.mMeshes[shown.object]),
          node_(shown.node),
          is_textured_(look && look->texture),
          T_world_object_(import.change.transform() * placeOf(import, shown)) {}

    Status add(bool rigged) {
        if (std::abs(T_world_object_.linear().determinant()) < 1e-18)
            return Done{};  // squashed flat: nobody sees it
        influences_.resize(object_.mNumVertices);
        if (rigged)
            if (const Status bones = addBones(); !bones)
                return bones;
        const auto first = static_cast<uint32_t>(import_.mesh.skin.vertices.size());
        for (unsigned v = 0; v < object_.mNumVertices; ++v)
            addVertex(v, rigged);
        return addTriangles(first);
    }

private:
    Error damaged(const std::string& what) const { return damagedMeshFile(import_.path, what); }

    Status addBones() {
        for (unsigned b = 0; b < object_.mNumBones; ++b) {
            const aiBone& bone = *object_.mBones[b];
            const auto node = import_.node_of_name.find(bone.mName.C_Str());
            if (node == import_.node_of_name.end())
                return damaged("bone " + std::string(bone.mName.C_Str()) + " is not in its tree");
            if (bone.mNumWeights == 0)
                continue;
            const auto index = boneOf(node->second, toEigen(bone.mOffsetMatrix));
            if (!index)
                return index.error();
            for (unsigned w = 0; w < bone.mNumWeights; ++w)
                if (const Status added = addWeight(bone.mWeights[w], *index, bone); !added)
                    return added;
        }
        return Done{};
    }

    Status addWeight(const aiVertexWeight& weight, uint16_t bone, const aiBone& from) {
        if (weight.mVertexId >= influences_.size())
            return damaged("bone " + std::string(from.mName.C_Str()) +
                           " weighs a vertex that does not exist");
        if (!(weight.mWeight >= -1e-3F && weight.mWeight < 1e6F))
            return damaged("bone " + std::string(from.mName.C_Str()) +
                           " has a weight that is negative or no number");
        if (weight.mWeight > 0)
            influences_[weight.mVertexId].push_back({bone, weight.mWeight});
        return Done{};
    }

    /// The skin's bone for a node; objects that bind the same node elsewhere get one of their own.
    Result<uint16_t> boneOf(int node, const Eigen::Affine3d& T_node_object) {
        Eigen::Affine3d T_bone = T_node_object * T_world_object_.inverse();
        T_bone.linear() *= import_.change.scale;
        T_bone.translation() *= import_.change.scale;
        const Eigen::Matrix4f bind = T_bone.matrix().cast<float>();
        RiggedMesh& mesh = import_.mesh;
        for (size_t b = 0; b < mesh.skin.bones.size(); ++b)
            if (mesh.node_of_bone[b] == node &&
                (mesh.skin.bones[b].bind_inverse - bind).norm() <= 1e-4F * bind.norm())
                return static_cast<uint16_t>(b);
        if (mesh.skin.bones.size() >= MeshLimits::kBones)
            return Error{ErrorKind::kUnusable, import_.path + ": it has too many bones",
                         "Export the body with fewer bones"};
        mesh.skin.bones.push_back({mesh.nodes[static_cast<size_t>(node)].name, bind});
        mesh.node_of_bone.push_back(node);
        return static_cast<uint16_t>(mesh.skin.bones.size() - 1);
    }

    void addVertex(unsigned v, bool rigged) {
        SkinnedVertex vertex;
        vertex.p_m = (T_world_object_ * toEigen(object_.mVertices[v])).cast<float>();
        if (object_.mNormals) {
            const Matrix3d turn = T_world_object_.linear().inverse().transpose();
            const Vector3d normal = turn * toEigen(object_.mNormals[v]);
            if (normal.norm() > 0)
                vertex.normal = normal.normalized().cast<float>();
        }
        // Seams of a texture that is not there would split vertices.
        if (const aiVector3D* uv = object_.mTextureCoords[0];
            is_textured_ && uv && isOnTexture({uv[v].x, uv[v].y}))
            vertex.uv = {uv[v].x, uv[v].y};
        if (rigged) {
            if (influences_[v].empty())
                influences_[v].push_back({ownBone(), 1});
            giveWeights(vertex, influences_[v]);
        }
        import_.mesh.skin.vertices.push_back(vertex);
    }

    /// What hangs on no bone follows the node of its object.
    uint16_t ownBone() {
        if (!own_bone_) {
            const auto bone = boneOf(node_, Eigen::Affine3d::Identity());
            own_bone_ = bone ? *bone : uint16_t{0};
        }
        return *own_bone_;
    }

    Status addTriangles(uint32_t first) {
        SkinnedMesh& skin = import_.mesh.skin;
        const size_t before = skin.triangles.size();
        const bool mirrored = T_world_object_.linear().determinant() < 0;
        for (unsigned f = 0; f < object_.mNumFaces; ++f) {
            const aiFace& face = object_.mFaces[f];
            if (face.mNumIndices != 3)
                continue;  // loose points and lines
            std::array<uint32_t, 3> corners{};
            for (unsigned i = 0; i < 3; ++i) {
                if (face.mIndices[i] >= object_.mNumVertices)
                    return damaged("triangle " + std::to_string(f) + " uses a vertex that does not exist");
                corners[i] = first + face.mIndices[i];
            }
            if (mirrored)
                std::swap(corners[1], corners[2]);
            skin.triangles.push_back(corners);
        }
        const std::string name = import_.scene.mNumMeshes == 1 || object_.mName.length == 0
                                     ? import_.mesh.nodes[static_cast<size_t>(node_)].name
                                     : object_.mName.C_Str();
        import_.mesh.parts.push_back(
            {name, static_cast<uint32_t>(before), static_cast<uint32_t>(skin.triangles.size() - before)});
        return Done{};
    }

    SceneImport& import_;
    const aiMesh& object_;
    int node_;
    bool is_textured_;
    Eigen::Affine3d T_world_object_;
    std::vector<std::vector<Influence>> influences_;
    std::optional<uint16_t> own_bone_;
};

/// Those of the first look first.
Result<std::vector<ShownObject>> objectsByLook(const SceneImport& import) {
    std::vector<ShownObject> objects;
    for (size_t n = 0; n < import.ai_nodes.size(); ++n)
        for (unsigned i = 0; i < import.ai_nodes[n]->mNumMeshes; ++i) {
            objects.push_back({static_cast<int>(n), import.ai_nodes[n]->mMeshes[i]});
            if (objects.back().object >= import.scene.mNumMeshes)
                return damagedMeshFile(import.path, "a node shows a mesh that does not exist");
        }
    std::stable_sort(objects.begin(), objects.end(), [&](const ShownObject& a, const ShownObject& b) {
        return import.look_of_object[a.object] < import.look_of_object[b.object];
    });
    return objects;
}

/// To the part of the last look when it has the same one.
void addToSurface(SkinnedMesh& skin, size_t first, const std::optional<SurfaceLook>& look,
                  bool same_as_before) {
    const auto count = static_cast<uint32_t>(skin.triangles.size() - first);
    if (count > 0 && same_as_before && !skin.surface.empty())
        skin.surface.back().triangles += count;
    else if (count > 0)
        skin.surface.push_back({static_cast<uint32_t>(first), count, look});
}

}  // namespace

Status importSkin(SceneImport& import) {
    const auto objects = objectsByLook(import);
    if (!objects)
        return objects.error();
    bool rigged = false;
    for (unsigned m = 0; m < import.scene.mNumMeshes; ++m)
        rigged = rigged || import.scene.mMeshes[m]->HasBones();
    std::optional<size_t> last_look;
    SkinnedMesh& skin = import.mesh.skin;
    for (const ShownObject& shown : *objects) {
        const unsigned m = shown.object;
        if (skin.vertices.size() + import.scene.mMeshes[m]->mNumVertices > MeshLimits::kVertices)
            return Error{
                ErrorKind::kUnusable,
                import.path + ": it has more than " + std::to_string(MeshLimits::kVertices) + " vertices",
                "Simplify the mesh in the program that made it"};
        const size_t look = import.look_of_object[m], first = skin.triangles.size();
        if (const Status added = ObjectImport(import, shown, import.looks[look]).add(rigged); !added)
            return added;
        addToSurface(skin, first, import.looks[look], last_look == look);
        if (skin.triangles.size() > first)
            last_look = look;
    }
    return Done{};
}

void findRestPose(RiggedMesh& mesh) {
    std::vector<int> bone_of_node(mesh.nodes.size(), -1);
    for (size_t b = mesh.node_of_bone.size(); b-- > 0;)
        bone_of_node[static_cast<size_t>(mesh.node_of_bone[b])] = static_cast<int>(b);
    for (size_t n = 0; n < mesh.nodes.size(); ++n) {
        RigNode& node = mesh.nodes[n];
        if (bone_of_node[n] >= 0)
            node.T_world_rest.matrix() =
                mesh.skin.bones[static_cast<size_t>(bone_of_node[n])].bind_inverse.cast<double>().inverse();
        else
            node.T_world_rest = node.parent < 0 ? node.T_parent_node
                                                : mesh.nodes[static_cast<size_t>(node.parent)].T_world_rest *
                                                      node.T_parent_node;
    }
}

}  // namespace noctule
