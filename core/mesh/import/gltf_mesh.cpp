// SPDX-License-Identifier: Apache-2.0
// Meshes and skins of a glTF document.
#include <algorithm>
#include <numeric>

#include "core/math/json.h"
#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

/// What the vertices of a primitive hang on: several joints each.
struct GltfWeights {
    std::vector<std::vector<aiVertexWeight>> of_joint;  ///< by place in the skin's list
    size_t loose = 0;                                   ///< vertices that hang on none
};

struct GltfSkin {
    std::vector<size_t> joints;  ///< nodes
    std::vector<Eigen::Affine3d> T_joint_skin;
    /// Absent: the skin is taken as it stands in the file, and its joints bind it there.
    std::optional<Eigen::Affine3d> T_file_skin;
};

/// Vertices and normals where the joints have them in the file.
void standInFile(aiMesh& mesh, const std::vector<std::vector<aiVertexWeight>>& of_joint,
                 const std::vector<Eigen::Affine3d>& T_file_skin) {
    std::vector<Eigen::Affine3d> sums(mesh.mNumVertices, Eigen::Affine3d(Eigen::Matrix4d::Zero()));
    std::vector<double> weights(mesh.mNumVertices, 0);
    for (size_t j = 0; j < of_joint.size(); ++j)
        for (const aiVertexWeight& on : of_joint[j]) {
            sums[on.mVertexId].matrix() += static_cast<double>(on.mWeight) * T_file_skin[j].matrix();
            weights[on.mVertexId] += static_cast<double>(on.mWeight);
        }
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const Eigen::Affine3d T(Eigen::Matrix4d(sums[v].matrix() / weights[v]));
        const Eigen::Vector3f p = (T * toEigen(mesh.mVertices[v])).cast<float>();
        const Vector3d turned = T.linear() * toEigen(mesh.mNormals[v]);
        const Eigen::Vector3f n = turned.normalized().cast<float>();
        mesh.mVertices[v] = gltfVector(p.data());
        mesh.mNormals[v] = gltfVector(n.data());
    }
}

class GltfMeshes {
public:
    GltfMeshes(const GltfDocument& document, const GltfNodes& nodes, const std::string& path)
        : document_(document), nodes_(nodes), path_(path) {}

    /// All that nodes of the shown scene show; every node with a skin gets an object of its own.
    Status add(GltfScene& made, const std::vector<aiNode*>& ai_nodes) {
        const std::vector<bool> shown = shownNodes();
        for (const int node : nodes_.order) {
            const auto n = static_cast<size_t>(node);
            const auto mesh = gltfIndex(document_.item("nodes", n), "mesh");
            if (!mesh || !shown[n])
                continue;
            const size_t first = meshes_.size();
            if (const Status added = addNode(made, n, *mesh); !added)
                return added;
            aiNode& shows = *ai_nodes[n];
            shows.mNumMeshes = static_cast<unsigned>(meshes_.size() - first);
            shows.mMeshes = new unsigned[shows.mNumMeshes];
            std::iota(shows.mMeshes, shows.mMeshes + shows.mNumMeshes, static_cast<unsigned>(first));
        }
        made.scene->mNumMeshes = static_cast<unsigned>(meshes_.size());
        made.scene->mMeshes = new aiMesh*[meshes_.size() + 1]();
        for (size_t m = 0; m < meshes_.size(); ++m)
            made.scene->mMeshes[m] = meshes_[m].release();
        return Done{};
    }

private:
    Error unusable(const std::string& what, const std::string& remedy) const {
        return {ErrorKind::kUnusable, path_ + ": " + what, remedy};
    }

    Error tooManyVertices() const {
        return unusable("it has more than " + std::to_string(MeshLimits::kVertices) + " vertices",
                        "Simplify the mesh in the program that made it");
    }

    /// Below the roots of the scene that is to be shown; all without one.
    std::vector<bool> shownNodes() const {
        const size_t scene = gltfIndex(document_.json(), "scene").value_or(0);
        const nlohmann::json& roots = gltfMember(document_.item("scenes", scene), "nodes");
        std::vector<bool> shown(nodes_.names.size(), !roots.is_array());
        for (const nlohmann::json& root : roots)
            if (root.is_number_unsigned() && nodes_.has(root.get<size_t>()))
                shown[root.get<size_t>()] = true;
        for (const int node : nodes_.order)
            if (const int parent = nodes_.parents[static_cast<size_t>(node)];
                parent >= 0 && shown[static_cast<size_t>(parent)])
                shown[static_cast<size_t>(node)] = true;
        return shown;
    }

    Status addNode(GltfScene& made, size_t node, size_t mesh) {
        const auto skin_index = gltfIndex(document_.item("nodes", node), "skin");
        std::optional<GltfSkin> skin;
        if (skin_index) {
            auto read = skinOf(*skin_index);
            if (!read)
                return read.error();
            skin = std::move(*read);
            skin->T_file_skin = spaceOf(*skin, node);
        }
        const nlohmann::json& told = document_.item("meshes", mesh);
        const std::string name = json::text(told, "name").value_or(nodes_.names[node]);
        for (const nlohmann::json& primitive : gltfMember(told, "primitives")) {
            auto object = gltfPrimitive(document_, primitive);
            if (!object)
                return object.error();
            if (!*object)
                continue;
            (*object)->mName = name;
            vertices_ += (*object)->mNumVertices;
            if (vertices_ > MeshLimits::kVertices)
                return tooManyVertices();
            if (skin)
                if (const Status done = addBones(**object, gltfMember(primitive, "attributes"), *skin, name);
                    !done)
                    return done;
            if (skin)
                made.T_file_object[static_cast<unsigned>(meshes_.size())] =
                    skin->T_file_skin.value_or(Eigen::Affine3d::Identity());
            meshes_.push_back(std::move(*object));
        }
        return Done{};
    }

    Result<GltfSkin> skinOf(size_t index) const {
        const nlohmann::json& told = document_.item("skins", index);
        const std::string name = "skin " + std::to_string(index);
        GltfSkin skin;
        for (const nlohmann::json& joint : gltfMember(told, "joints")) {
            if (!joint.is_number_unsigned() || !nodes_.has(joint.get<size_t>()))
                return document_.damaged(name + " names a joint that does not exist");
            skin.joints.push_back(joint.get<size_t>());
        }
        if (skin.joints.empty())
            return document_.damaged(name + " has no joints");
        const auto accessor = gltfIndex(told, "inverseBindMatrices");
        if (!accessor) {
            skin.T_joint_skin.assign(skin.joints.size(), Eigen::Affine3d::Identity());
            return skin;
        }
        const auto matrices = document_.numbers(*accessor, 16);
        if (!matrices)
            return matrices.error();
        if (matrices->count() < skin.joints.size())
            return document_.damaged(name + " has fewer matrices than joints");
        for (size_t j = 0; j < skin.joints.size(); ++j) {
            Eigen::Affine3d T = Eigen::Affine3d::Identity();
            T.matrix().topRows<3>() =
                Eigen::Map<const Eigen::Matrix4f>(matrices->at(j)).cast<double>().topRows<3>();
            skin.T_joint_skin.push_back(T);
        }
        return skin;
    }

    std::optional<Eigen::Affine3d> spaceOf(const GltfSkin& skin, size_t node) const {
        std::vector<Eigen::Affine3d> T_bind, T_file;
        for (size_t j = 0; j < skin.joints.size(); ++j) {
            const Eigen::Affine3d T = skin.T_joint_skin[j].inverse();
            if (!T.matrix().allFinite())
                continue;
            T_bind.push_back(T);
            T_file.push_back(nodes_.T_file_node[skin.joints[j]]);
        }
        return gltfBindSpace(T_bind, T_file, nodes_.T_file_node[node]);
    }

    /// All sets of four: JOINTS_0, JOINTS_1...
    Result<GltfWeights> weightsOf(const nlohmann::json& attributes, size_t vertices, size_t joints) const {
        GltfWeights made{std::vector<std::vector<aiVertexWeight>>(joints), 0};
        std::vector<float> sums(vertices, 0);
        for (size_t set = 0; set < 16; ++set) {
            const auto joint_accessor = gltfIndex(attributes, ("JOINTS_" + std::to_string(set)).c_str());
            const auto weight_accessor = gltfIndex(attributes, ("WEIGHTS_" + std::to_string(set)).c_str());
            if (!joint_accessor || !weight_accessor)
                break;
            const auto indices = document_.indices(*joint_accessor);
            if (!indices)
                return indices.error();
            const auto weights = document_.numbers(*weight_accessor, 4);
            if (!weights)
                return weights.error();
            if (weights->count() != vertices || indices->size() != 4 * vertices)
                return document_.damaged("it has fewer weights than vertices");
            for (size_t i = 0; i < 4 * vertices; ++i) {
                const float weight = weights->values[i];
                if (!(weight != 0))
                    continue;
                if ((*indices)[i] >= joints)
                    return document_.damaged("a vertex hangs on a joint that its skin does not have");
                made.of_joint[(*indices)[i]].emplace_back(static_cast<unsigned>(i / 4), weight);
                sums[i / 4] += weight;
            }
        }
        made.loose = static_cast<size_t>(
            std::count_if(sums.begin(), sums.end(), [](float sum) { return !(sum > 0); }));
        return made;
    }

    Status addBones(aiMesh& object, const nlohmann::json& attributes, const GltfSkin& skin,
                    const std::string& name) {
        auto weights = weightsOf(attributes, object.mNumVertices, skin.joints.size());
        if (!weights)
            return weights.error();
        if (weights->loose > 0)
            return unusable(
                std::to_string(weights->loose) + " of " + std::to_string(object.mNumVertices) +
                    " vertices of " + name + " hang on no bone",
                "Give every vertex a weight (in Blender: Parent, With Automatic Weights), and export again");
        std::vector<Eigen::Affine3d> T_joint_object = skin.T_joint_skin;
        if (!skin.T_file_skin) {
            std::vector<Eigen::Affine3d> T_file_skin;
            for (size_t j = 0; j < skin.joints.size(); ++j) {
                const Eigen::Affine3d& T_file_joint = nodes_.T_file_node[skin.joints[j]];
                T_file_skin.push_back(T_file_joint * skin.T_joint_skin[j]);
                T_joint_object[j] = T_file_joint.inverse();
            }
            standInFile(object, weights->of_joint, T_file_skin);
        }
        object.mBones = new aiBone*[skin.joints.size()]();
        for (size_t j = 0; j < skin.joints.size(); ++j) {
            const std::vector<aiVertexWeight>& on_joint = weights->of_joint[j];
            if (on_joint.empty())
                continue;
            auto bone = std::make_unique<aiBone>();
            bone->mName = nodes_.names[skin.joints[j]];
            bone->mOffsetMatrix = gltfMatrix(T_joint_object[j]);
            bone->mNumWeights = static_cast<unsigned>(on_joint.size());
            bone->mWeights = new aiVertexWeight[on_joint.size()];
            std::copy(on_joint.begin(), on_joint.end(), bone->mWeights);
            object.mBones[object.mNumBones++] = bone.release();
        }
        return Done{};
    }

    const GltfDocument& document_;
    const GltfNodes& nodes_;
    const std::string& path_;
    std::vector<std::unique_ptr<aiMesh>> meshes_;
    size_t vertices_ = 0;
};

}  // namespace

Status addGltfMeshes(const GltfDocument& document, const GltfNodes& nodes, const std::string& path,
                     const std::vector<aiNode*>& ai_nodes, GltfScene& made) {
    return GltfMeshes(document, nodes, path).add(made, ai_nodes);
}

}  // namespace noctule
