// SPDX-License-Identifier: Apache-2.0
// The surface of a glTF document, piece by piece.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

constexpr size_t kTriangles = 4, kStrip = 5, kFan = 6;

/// Corners of triangles, whatever the primitive lists.
std::vector<std::array<uint32_t, 3>> gltfTriangles(const std::vector<uint32_t>& corners, size_t mode) {
    std::vector<std::array<uint32_t, 3>> triangles;
    if (mode == kTriangles)
        for (size_t i = 0; i + 2 < corners.size(); i += 3)
            triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    for (size_t i = 0; mode == kStrip && i + 2 < corners.size(); ++i)
        triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    for (size_t i = 1; mode == kFan && i + 1 < corners.size(); ++i)
        triangles.push_back({corners[i], corners[i + 1], corners[0]});
    return triangles;
}

/// Of the surface, alike where points share a place.
void giveNormals(aiMesh& mesh) {
    struct Less {
        bool operator()(const aiVector3D& a, const aiVector3D& b) const {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        }
    };
    std::map<aiVector3D, aiVector3D, Less> sums;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const unsigned* c = mesh.mFaces[f].mIndices;
        const aiVector3D normal =
            (mesh.mVertices[c[1]] - mesh.mVertices[c[0]]) ^ (mesh.mVertices[c[2]] - mesh.mVertices[c[0]]);
        for (unsigned i = 0; i < 3; ++i)
            sums[mesh.mVertices[c[i]]] += normal;
    }
    mesh.mNormals = new aiVector3D[mesh.mNumVertices];
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
        if (const auto sum = sums.find(mesh.mVertices[v]); sum != sums.end())
            mesh.mNormals[v] = sum->second.NormalizeSafe();
}

void putTriangles(aiMesh& mesh, const std::vector<std::array<uint32_t, 3>>& triangles) {
    mesh.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh.mNumFaces = static_cast<unsigned>(triangles.size());
    mesh.mFaces = new aiFace[triangles.size()];
    for (size_t t = 0; t < triangles.size(); ++t) {
        mesh.mFaces[t].mNumIndices = 3;
        mesh.mFaces[t].mIndices = new unsigned[3]{triangles[t][0], triangles[t][1], triangles[t][2]};
    }
}

Status addFaces(const GltfDocument& document, aiMesh& object, const nlohmann::json& primitive, size_t mode) {
    std::vector<uint32_t> corners(object.mNumVertices);
    std::iota(corners.begin(), corners.end(), 0U);
    if (const auto accessor = gltfIndex(primitive, "indices")) {
        auto read = document.indices(*accessor);
        if (!read)
            return read.error();
        corners = std::move(*read);
    }
    for (const uint32_t corner : corners)
        if (corner >= object.mNumVertices)
            return document.damaged("a triangle uses a vertex that does not exist");
    putTriangles(object, gltfTriangles(corners, mode));
    return Done{};
}

Status addNormals(const GltfDocument& document, aiMesh& object, const nlohmann::json& attributes) {
    const auto accessor = gltfIndex(attributes, "NORMAL");
    if (!accessor) {
        giveNormals(object);
        return Done{};
    }
    const auto normals = document.numbers(*accessor, 3);
    if (!normals)
        return normals.error();
    if (normals->count() != object.mNumVertices)
        return document.damaged("it has fewer normals than vertices");
    object.mNormals = new aiVector3D[object.mNumVertices + 1];
    for (size_t v = 0; v < normals->count(); ++v)
        object.mNormals[v] = gltfVector(normals->at(v));
    return Done{};
}

/// glTF counts from the upper left corner, we from the lower left.
Status addTexturePlaces(const GltfDocument& document, aiMesh& object, const nlohmann::json& attributes) {
    const GltfTexturePlace place = gltfTexturePlace(document.item("materials", object.mMaterialIndex));
    const auto accessor = gltfIndex(attributes, ("TEXCOORD_" + std::to_string(place.set)).c_str());
    if (!accessor)
        return Done{};
    const auto places = document.numbers(*accessor, 2);
    if (!places)
        return places.error();
    if (places->count() != object.mNumVertices)
        return document.damaged("it has fewer texture coordinates than vertices");
    object.mNumUVComponents[0] = 2;
    object.mTextureCoords[0] = new aiVector3D[object.mNumVertices + 1];
    for (size_t v = 0; v < places->count(); ++v) {
        const Eigen::Vector2f uv = place.change * Eigen::Vector2f(places->at(v)[0], places->at(v)[1]);
        object.mTextureCoords[0][v] = {uv.x(), 1 - uv.y(), 0};
    }
    return Done{};
}

}  // namespace

Result<std::unique_ptr<aiMesh>> gltfPrimitive(const GltfDocument& document, const nlohmann::json& primitive) {
    const nlohmann::json& attributes = gltfMember(primitive, "attributes");
    const size_t mode = gltfIndex(primitive, "mode").value_or(kTriangles);
    const auto position = gltfIndex(attributes, "POSITION");
    if (!position || mode < kTriangles || mode > kFan)
        return std::unique_ptr<aiMesh>();
    const auto points = document.numbers(*position, 3);
    if (!points)
        return points.error();
    auto object = std::make_unique<aiMesh>();
    object->mNumVertices = static_cast<unsigned>(points->count());
    object->mVertices = new aiVector3D[points->count() + 1];
    for (size_t v = 0; v < points->count(); ++v)
        object->mVertices[v] = gltfVector(points->at(v));
    object->mMaterialIndex =
        static_cast<unsigned>(gltfIndex(primitive, "material").value_or(document.count("materials")));
    if (const Status done = addFaces(document, *object, primitive, mode); !done)
        return done.error();
    if (const Status done = addNormals(document, *object, attributes); !done)
        return done.error();
    if (const Status done = addTexturePlaces(document, *object, attributes); !done)
        return done.error();
    return object;
}

}  // namespace noctule
