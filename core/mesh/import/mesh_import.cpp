// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/import/mesh_import.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <filesystem>

#include "core/mesh/import/gltf_scene.h"
#include "core/mesh/surface_graph.h"

namespace noctule {
namespace {

constexpr const char* kSuffixes[] = {".glb", ".gltf", ".vrm", ".fbx", ".dae", ".obj", ".ply"};

std::string suffixOf(const std::string& path) {
    std::string suffix = std::filesystem::path(path).extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix;
}

Status checkFile(const std::string& path, const MeshImportSettings& settings) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        return Error{ErrorKind::kUnreadable, path + ": there is no such file",
                     "Choose a .glb, .gltf, .vrm, .fbx, .dae, .obj or .ply file"};
    const bool is_part = settings.keeps_axes && suffixOf(path) == ".stl";
    if (!is_part && !isMeshFileName(path))
        return Error{ErrorKind::kUnreadable, path + ": meshes of this kind cannot be read",
                     "Export the body as .glb, .fbx, .dae, .obj or .ply"};
    return Done{};
}

/// Vertices that are the same in all they hold become one: FBX and OBJ come with one per corner.
void weld(SkinnedMesh& skin) {
    struct Less {
        bool operator()(const SkinnedVertex* a, const SkinnedVertex* b) const {
            const auto key = [](const SkinnedVertex& v) {
                return std::tuple(v.p_m.x(), v.p_m.y(), v.p_m.z(), v.normal.x(), v.normal.y(), v.normal.z(),
                                  v.bones, v.weights, v.uv.x(), v.uv.y());
            };
            return key(*a) < key(*b);
        }
    };
    std::map<const SkinnedVertex*, uint32_t, Less> first_of;
    std::vector<uint32_t> moved;
    std::vector<SkinnedVertex> kept;
    moved.reserve(skin.vertices.size());
    for (const SkinnedVertex& vertex : skin.vertices) {
        const auto [entry, is_new] = first_of.try_emplace(&vertex, static_cast<uint32_t>(kept.size()));
        if (is_new)
            kept.push_back(vertex);
        moved.push_back(entry->second);
    }
    skin.vertices = std::move(kept);
    for (auto& triangle : skin.triangles)
        for (uint32_t& corner : triangle)
            corner = moved[corner];
}

/// Normals of the surface itself where those of the file point elsewhere: some programs store them for
/// another pose than the one in which they bind the skin.
void mendNormals(SkinnedMesh& skin) {
    constexpr double kMayDiffer = 0.01;  // of all triangles; small ones may be wrong by rounding
    const WeldedSurface surface = welded(skin);
    std::vector<Vector3d> normals(surface.mesh.points.size(), Vector3d::Zero());
    size_t against = 0;
    for (const auto& [a, b, c] : skin.triangles) {
        const auto p = [&](uint32_t v) { return Vector3d(skin.vertices[v].p_m.cast<double>()); };
        const Vector3d normal = (p(b) - p(a)).cross(p(c) - p(a));
        const Eigen::Vector3f told =
            skin.vertices[a].normal + skin.vertices[b].normal + skin.vertices[c].normal;
        against += normal.dot(told.cast<double>()) < 0;
        for (const uint32_t corner : {a, b, c})
            normals[surface.point_of[corner]] += normal;
    }
    if (static_cast<double>(against) <= kMayDiffer * static_cast<double>(skin.triangles.size()))
        return;
    for (size_t v = 0; v < skin.vertices.size(); ++v)
        if (const Vector3d& normal = normals[surface.point_of[v]]; normal.norm() > 0)
            skin.vertices[v].normal = normal.normalized().cast<float>();
}

Result<RiggedMesh> fromScene(SceneImport import, const MeshImportSettings& settings) {
    importNodes(import);
    importLooks(import, settings.decode);
    if (const Status skin = importSkin(import); !skin)
        return skin.error();
    findRestPose(import.mesh);
    if (const Status clips = importClips(import); !clips)
        return clips.error();
    if (const Status checked = checkRiggedMesh(import.mesh, import.path); !checked)
        return checked.error();
    if (settings.needs_surface && import.mesh.skin.triangles.empty())
        return Error{ErrorKind::kUnusable, import.path + ": there is no triangle in it",
                     "Export the body's surface as a mesh"};
    mendNormals(import.mesh.skin);
    weld(import.mesh.skin);
    return std::move(import.mesh);
}

SceneImport importOf(const aiScene& scene, const std::string& path, const MeshImportSettings& settings) {
    return {scene, path, worldChangeOf(scene, suffixOf(path), settings), {}, {}, {}, {}, {}, {}, {}};
}

bool isGltf(const std::string& path) {
    const std::string suffix = suffixOf(path);
    return suffix == ".glb" || suffix == ".gltf" || suffix == ".vrm";
}

Result<RiggedMesh> importGltf(const std::string& path, const MeshImportSettings& settings) {
    const auto document = GltfDocument::open(path);
    if (!document)
        return document.error();
    auto gltf = gltfScene(*document, path);
    if (!gltf)
        return gltf.error();
    SceneImport import = importOf(*gltf->scene, path, settings);
    import.T_file_object = std::move(gltf->T_file_object);
    import.mesh.humanoid = std::move(gltf->humanoid);
    return fromScene(std::move(import), settings);
}

}  // namespace

Error damagedMeshFile(const std::string& path, const std::string& what) {
    return {ErrorKind::kUnreadable, path + ": " + what,
            "Export the mesh again; this file is damaged or was written wrongly"};
}

bool isMeshFileName(const std::string& path) {
    const std::string suffix = suffixOf(path);
    return std::any_of(std::begin(kSuffixes), std::end(kSuffixes),
                       [&](const char* known) { return suffix == known; });
}

Result<RiggedMesh> importMesh(const std::string& path, const MeshImportSettings& settings) {
    if (const Status checked = checkFile(path, settings); !checked)
        return checked.error();
    if (isGltf(path))
        return importGltf(path, settings);
    Assimp::Importer importer;
    // Maya's pivots folded into the nodes, so that bones keep their own names and stand in one piece.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, settings.keeps_axes);
    const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_GenSmoothNormals);
    if (!scene || !scene->mRootNode)
        return Error{ErrorKind::kUnreadable,
                     path + ": this is no mesh that can be read (" + importer.GetErrorString() + ")",
                     "Export the body again, best as binary glTF (.glb)"};
    return fromScene(importOf(*scene, path, settings), settings);
}

}  // namespace noctule
