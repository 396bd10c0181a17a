// SPDX-License-Identifier: Apache-2.0
// The steps from assimp's scene to a RiggedMesh. Inside the importer only.
#pragma once

#include <assimp/scene.h>

#include <map>
#include <string>

#include "core/mesh/import/mesh_import.h"

namespace noctule {

/// From the file's world to ours: v' = turn * scale * v.
struct WorldChange {
    Matrix3d turn = Matrix3d::Identity();
    double scale = 1;

    Eigen::Affine3d transform() const {
        return Eigen::Affine3d(Eigen::Affine3d::MatrixType::Identity()).scale(scale).rotate(turn);
    }
};

/// As the file says (FBX: axes and unit; glTF and Collada come in metres, Y up); OBJ and PLY: guessed.
WorldChange worldChangeOf(const aiScene& scene, const std::string& suffix,
                          const MeshImportSettings& settings);

struct SceneImport {
    const aiScene& scene;
    std::string path;
    WorldChange change;
    RiggedMesh mesh;
    std::vector<const aiNode*> ai_nodes;       ///< as mesh.nodes
    std::vector<Eigen::Affine3d> T_file_node;  ///< world of the file, as it stands
    std::map<std::string, int> node_of_name;
    std::vector<std::optional<SurfaceLook>> looks;  ///< each once, in the order of the objects that have them
    std::vector<size_t> look_of_object;             ///< as scene.mMeshes
    /// Skinned objects of glTF, whose nodes do not place them: world of the file from the object, by index in
    /// scene.mMeshes. Others stand at their nodes.
    std::map<unsigned, Eigen::Affine3d> T_file_object;
};

/// Transforms in metres: translations are scaled, so that no node carries the unit.
void importNodes(SceneImport& import);
/// What colours the objects: their materials, and the textures of these from within the file or beside it. A
/// texture that is not there is no trouble.
void importLooks(SceneImport& import, TextureDecoder decode);
/// The surface, objects of one look after each other.
Status importSkin(SceneImport& import);
/// Puts bound nodes where their bones were bound.
void findRestPose(RiggedMesh& mesh);
Status importClips(SceneImport& import);

Eigen::Affine3d toEigen(const aiMatrix4x4& m);
inline Vector3d toEigen(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}
inline Quaterniond toEigen(const aiQuaternion& q) {
    return Quaterniond(q.w, q.x, q.y, q.z).normalized();
}
Error damagedMeshFile(const std::string& path, const std::string& what);

}  // namespace noctule
