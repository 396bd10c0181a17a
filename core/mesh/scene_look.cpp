// SPDX-License-Identifier: Apache-2.0
// Colour and texture of a mesh.
#include <assimp/material.h>

#include <algorithm>
#include <filesystem>

#include "core/job/atomic_file.h"
#include "core/mesh/scene_import.h"

namespace noctule {
namespace {

/// Index of the material of most triangles, -1: none.
int mainMaterial(const aiScene& scene) {
    std::map<unsigned, size_t> triangles;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        triangles[scene.mMeshes[m]->mMaterialIndex] += scene.mMeshes[m]->mNumFaces;
    int most = -1;
    for (const auto& [material, count] : triangles)
        if (material < scene.mNumMaterials && (most < 0 || count > triangles[static_cast<unsigned>(most)]))
            most = static_cast<int>(material);
    return most;
}

/// What the file names, within it or in its own folder; wherever else the path may point is not looked at.
std::string textureFile(const aiScene& scene, const std::string& mesh_path, const aiString& named) {
    if (const aiTexture* embedded = scene.GetEmbeddedTexture(named.C_Str()))
        return embedded->mHeight == 0
                   ? std::string(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth)
                   : std::string();
    std::string name = named.C_Str();
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path beside =
        std::filesystem::path(mesh_path).parent_path() / std::filesystem::path(name).filename();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(beside, ignored) ||
        std::filesystem::file_size(beside, ignored) > MeshLimits::kTextureBytes)
        return {};
    auto bytes = readWholeFile(beside.string());
    return bytes ? std::move(*bytes) : std::string();
}

}  // namespace

void importLook(SceneImport& import, TextureDecoder decode) {
    const int main = mainMaterial(import.scene);
    if (main < 0)
        return;
    const aiMaterial& material = *import.scene.mMaterials[main];
    aiColor4D color(1, 1, 1, 1);
    const bool is_colored = material.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS ||
                            material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS;
    SurfaceLook look;
    look.base_color = Eigen::Vector3f(color.r, color.g, color.b).cwiseMax(0).cwiseMin(1);
    aiString named;
    for (const aiTextureType kind : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
        if (look.texture || material.GetTexture(kind, 0, &named) != AI_SUCCESS)
            continue;
        SurfaceTexture texture{textureFile(import.scene, import.path, named)};
        if (!isPictureFile(texture.file))
            continue;
        if (decode)
            decode(texture);
        look.texture = std::make_shared<const SurfaceTexture>(std::move(texture));
        aiColor4D factor;
        if (material.Get(AI_MATKEY_BASE_COLOR, factor) != AI_SUCCESS)  // glTF alone multiplies
            look.base_color.setOnes();
    }
    if ((is_colored || look.texture) && look.base_color.allFinite())
        import.mesh.skin.look = look;
}

}  // namespace noctule
