// SPDX-License-Identifier: Apache-2.0
// Materials and textures of a glTF document.
#include <assimp/material.h>

#include <cstring>

#include "core/math/json.h"
#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

/// The base colour of a material: metallic and roughness, or the older specular and glossiness.
struct GltfBaseColor {
    const nlohmann::json *factor, *texture;
};

GltfBaseColor baseColorOf(const nlohmann::json& material) {
    const nlohmann::json& old =
        gltfMember(gltfMember(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
    if (old.is_object())
        return {&gltfMember(old, "diffuseFactor"), &gltfMember(old, "diffuseTexture")};
    const nlohmann::json& usual = gltfMember(material, "pbrMetallicRoughness");
    return {&gltfMember(usual, "baseColorFactor"), &gltfMember(usual, "baseColorTexture")};
}

/// Pictures within the document become textures of the scene; others keep the name of their file.
class GltfPictures {
public:
    explicit GltfPictures(const GltfDocument& document)
        : document_(document), names_(document.count("images")) {}

    /// Empty when there is none.
    std::string nameOf(size_t texture) {
        const auto image = gltfIndex(document_.item("textures", texture), "source");
        if (!image || *image >= names_.size())
            return {};
        std::string& name = names_[*image];
        if (name.empty())
            name = read(document_.item("images", *image));
        return name;
    }

    void giveTo(aiScene& scene) {
        scene.mNumTextures = static_cast<unsigned>(embedded_.size());
        scene.mTextures = embedded_.empty() ? nullptr : new aiTexture*[embedded_.size()];
        for (size_t t = 0; t < embedded_.size(); ++t)
            scene.mTextures[t] = embedded_[t].release();
    }

private:
    std::string read(const nlohmann::json& image) {
        const auto uri = json::text(image, "uri");
        if (uri && !uri->starts_with("data:"))
            return percentDecoded(*uri);
        const auto index = gltfIndex(image, "bufferView");
        const auto view = index ? document_.view(*index) : std::nullopt;
        const auto data = uri ? dataOfUri(*uri) : std::nullopt;
        if (view)
            return embed(*view);
        return data ? embed(*data) : std::string();
    }

    std::string embed(std::string_view bytes) {
        auto texture = std::make_unique<aiTexture>();
        const size_t words = (bytes.size() + sizeof(aiTexel) - 1) / sizeof(aiTexel);
        texture->mWidth = static_cast<unsigned>(bytes.size());
        texture->pcData = new aiTexel[words + 1];
        std::memcpy(static_cast<void*>(texture->pcData), bytes.data(), bytes.size());
        embedded_.push_back(std::move(texture));
        return "*" + std::to_string(embedded_.size() - 1);
    }

    const GltfDocument& document_;
    std::vector<std::string> names_;
    std::vector<std::unique_ptr<aiTexture>> embedded_;
};

std::unique_ptr<aiMaterial> materialOf(const nlohmann::json& told, GltfPictures& pictures) {
    const GltfBaseColor base = baseColorOf(told);
    aiColor4D color(1, 1, 1, 1);
    if (base.factor->is_array() && base.factor->size() >= 3)
        for (unsigned c = 0; c < 3; ++c)
            color[c] = static_cast<float>(json::number((*base.factor)[c]).value_or(1));
    auto material = std::make_unique<aiMaterial>();
    material->AddProperty(&color, 1, AI_MATKEY_BASE_COLOR);
    if (const auto texture = gltfIndex(*base.texture, "index")) {
        const std::string name = pictures.nameOf(*texture);
        const aiString path(name);
        if (!name.empty() && name.size() < MAXLEN)
            material->AddProperty(&path, AI_MATKEY_TEXTURE(aiTextureType_BASE_COLOR, 0));
    }
    return material;
}

}  // namespace

void addGltfLooks(const GltfDocument& document, aiScene& scene) {
    GltfPictures pictures(document);
    const size_t count = document.count("materials");
    scene.mMaterials = new aiMaterial*[count + 1]();
    for (size_t m = 0; m < count; ++m)
        scene.mMaterials[scene.mNumMaterials++] =
            materialOf(document.item("materials", m), pictures).release();
    pictures.giveTo(scene);
}

GltfTexturePlace gltfTexturePlace(const nlohmann::json& material) {
    GltfTexturePlace place;
    const nlohmann::json& texture = *baseColorOf(material).texture;
    place.set = gltfIndex(texture, "texCoord").value_or(0);
    const nlohmann::json& told = gltfMember(gltfMember(texture, "extensions"), "KHR_texture_transform");
    if (!told.is_object())
        return place;
    place.set = gltfIndex(told, "texCoord").value_or(place.set);
    const auto pair = [&](const char* member, float otherwise) {
        const nlohmann::json& values = gltfMember(told, member);
        Eigen::Vector2f two(otherwise, otherwise);
        for (Eigen::Index i = 0; i < 2 && values.is_array() && values.size() == 2; ++i)
            two[i] = static_cast<float>(
                json::number(values[static_cast<size_t>(i)]).value_or(static_cast<double>(otherwise)));
        return two;
    };
    // From the upper left corner, as glTF counts: the matrix of the extension's text.
    const auto turn = static_cast<float>(json::number(told, "rotation").value_or(0));
    place.change.translation() = pair("offset", 0);
    place.change.linear() = Eigen::Rotation2Df(-turn).toRotationMatrix() * pair("scale", 1).asDiagonal();
    return place;
}

}  // namespace noctule
