// SPDX-License-Identifier: Apache-2.0
// A glTF document as assimp's scene, so that all formats take the same way to a RiggedMesh. Inside the
// importer only; gltf_document.h says why assimp does not read it itself.
//
// As the format demands: the node transform of a skinned mesh has no effect; a missing list of inverse bind
// matrices means identity; nodes are told apart by index. Their names become unique here: bones keep theirs,
// of two alike the second and whatever is no bone gets a number.
#pragma once

#include <assimp/scene.h>

#include <map>
#include <memory>

#include "core/mesh/import/gltf_document.h"
#include "core/mesh/import/scene_import.h"

namespace noctule {

struct GltfScene {
    std::unique_ptr<aiScene> scene;
    /// World of the file from a skinned object's own space, by index in scene->mMeshes; others stand at their
    /// nodes.
    std::map<unsigned, Eigen::Affine3d> T_file_object;
    /// Canonical joint -> name of its node, as VRM 0 and 1 say; empty without.
    std::map<std::string, std::string> humanoid;
};

/// kUnreadable: damaged; kUnusable: a skin without weights, or too large.
Result<GltfScene> gltfScene(const GltfDocument& document, const std::string& path);

/// The nodes of a document: their tree, unique names and places.
struct GltfNodes {
    std::vector<std::string> names;
    std::vector<int> parents;  ///< -1: a root
    std::vector<std::vector<int>> children;
    std::vector<int> order;  ///< parents first
    std::vector<Eigen::Affine3d> T_parent_node, T_file_node;

    bool has(size_t node) const { return node < names.size(); }
};
Result<GltfNodes> gltfNodes(const GltfDocument& document);

/// Where the space in which a skin was bound lies in the file's world: the joints bound there stand where
/// their nodes do, or nearest to that. glTF leaves it open, as only the product with a joint counts.
/// `T_bind`: joints in the space of the skin; `T_file`: where their nodes stand; `T_mesh`: the skinned node.
/// Absent: no pose of the joints looks like that bind; all matrices are the identity, for example.
std::optional<Eigen::Affine3d> gltfBindSpace(const std::vector<Eigen::Affine3d>& T_bind,
                                             const std::vector<Eigen::Affine3d>& T_file,
                                             const Eigen::Affine3d& T_mesh);

/// Points, triangles, normals (of the surface where there are none) and texture coordinates. Null: no
/// triangles.
Result<std::unique_ptr<aiMesh>> gltfPrimitive(const GltfDocument& document, const nlohmann::json& primitive);
/// All that nodes of the shown scene show, with skins; `ai_nodes` as the document's nodes.
Status addGltfMeshes(const GltfDocument& document, const GltfNodes& nodes, const std::string& path,
                     const std::vector<aiNode*>& ai_nodes, GltfScene& made);
/// Materials and textures; materials as many as the document has.
void addGltfLooks(const GltfDocument& document, aiScene& scene);

/// Which texture coordinates a material uses, and how it places them (KHR_texture_transform).
struct GltfTexturePlace {
    size_t set = 0;
    Eigen::Affine2f change = Eigen::Affine2f(Eigen::Affine2f::MatrixType::Identity());
};
GltfTexturePlace gltfTexturePlace(const nlohmann::json& material);

Status addGltfClips(const GltfDocument& document, const GltfNodes& nodes, aiScene& scene);
std::map<std::string, std::string> gltfHumanoid(const GltfDocument& document, const GltfNodes& nodes);

inline aiVector3D gltfVector(const float* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}
aiMatrix4x4 gltfMatrix(const Eigen::Affine3d& T);

}  // namespace noctule
