// SPDX-License-Identifier: Apache-2.0
// Colours and textures of a mesh.
#include <assimp/material.h>

#include <algorithm>
#include <filesystem>

#include "core/job/atomic_file.h"
#include "core/mesh/import/scene_import.h"

namespace noctule {
namespace {

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

/// No larger than all of them may be together.
int sideFor(size_t textures) {
    const auto bytes = [&](int side_px) { return 4 * textures * static_cast<size_t>(side_px * side_px); };
    int side_px = MeshLimits::kTextureSide_px;
    while (side_px > 1 && bytes(side_px) > MeshLimits::kTexturesBytes)
        side_px /= 2;
    return side_px;
}

/// Materials that come to the same are one look, pictures that are the same one texture.
class LookImport {
public:
    explicit LookImport(SceneImport& import) : import_(import) {}

    void run(TextureDecoder decode) {
        std::map<unsigned, size_t> look_of_material;
        for (unsigned m = 0; m < import_.scene.mNumMeshes; ++m) {
            const unsigned material = import_.scene.mMeshes[m]->mMaterialIndex;
            auto known = look_of_material.find(material);
            if (known == look_of_material.end())
                known = look_of_material.emplace(material, indexOf(lookOf(material))).first;
            import_.look_of_object.push_back(known->second);
        }
        for (const auto& texture : textures_)
            if (decode)
                decode(*texture, sideFor(textures_.size()));
    }

private:
    size_t indexOf(const std::optional<SurfaceLook>& look) {
        const auto same = [&](const std::optional<SurfaceLook>& other) {
            return look.has_value() == other.has_value() &&
                   (!look || (look->base_color == other->base_color && look->texture == other->texture));
        };
        const auto found = std::find_if(import_.looks.begin(), import_.looks.end(), same);
        if (found != import_.looks.end())
            return static_cast<size_t>(found - import_.looks.begin());
        import_.looks.push_back(look);
        return import_.looks.size() - 1;
    }

    std::optional<SurfaceLook> lookOf(unsigned index) {
        if (index >= import_.scene.mNumMaterials)
            return std::nullopt;
        const aiMaterial& material = *import_.scene.mMaterials[index];
        aiColor4D color(1, 1, 1, 1), factor;
        const bool is_colored = material.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS ||
                                material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS;
        SurfaceLook look;
        look.base_color = Eigen::Vector3f(color.r, color.g, color.b).cwiseMax(0).cwiseMin(1);
        look.texture = textureOf(material);
        if (look.texture && material.Get(AI_MATKEY_BASE_COLOR, factor) != AI_SUCCESS)
            look.base_color.setOnes();  // glTF alone multiplies
        return (is_colored || look.texture) && look.base_color.allFinite() ? std::optional(look)
                                                                           : std::nullopt;
    }

    std::shared_ptr<const SurfaceTexture> textureOf(const aiMaterial& material) {
        aiString named;
        for (const aiTextureType kind : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
            if (material.GetTexture(kind, 0, &named) != AI_SUCCESS)
                continue;
            SurfaceTexture texture{textureFile(import_.scene, import_.path, named)};
            if (!isPictureFile(texture.file))
                continue;
            for (const auto& known : textures_)
                if (known->file == texture.file)
                    return known;
            return textures_.emplace_back(std::make_shared<SurfaceTexture>(std::move(texture)));
        }
        return nullptr;
    }

    SceneImport& import_;
    std::vector<std::shared_ptr<SurfaceTexture>> textures_;
};

}  // namespace

void importLooks(SceneImport& import, TextureDecoder decode) {
    LookImport(import).run(decode);
}

}  // namespace noctule
