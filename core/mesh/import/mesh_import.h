// SPDX-License-Identifier: Apache-2.0
// Meshes of other programs: glTF, GLB and VRM (gltf_document.h), through assimp FBX and Collada with their
// rigs and animations, OBJ and PLY without. The library trusts what it reads, so files from outside go
// through importMeshApart() (mesh_reader.h), which does this in a process of its own.
#pragma once

#include <optional>
#include <string>

#include "core/job/result.h"
#include "core/mesh/rigged_mesh.h"

namespace noctule {

/// Makes `rgba` of a texture's file, no side longer than `side_px`; without success it stays empty.
using TextureDecoder = void (*)(SurfaceTexture& texture, int side_px);

struct MeshImportSettings {
    /// Metres per unit of the file. Absent: what the file says. OBJ and PLY say nothing: then the usual unit
    /// that makes the figure as tall as a person, metres when none does.
    std::optional<double> unit_m;
    TextureDecoder decode = nullptr;  ///< null: textures are carried, but cannot be drawn
    bool needs_surface = true;        ///< false: nodes and their animations alone will do
    bool keeps_axes = false;  ///< a part of a machine, also STL: no axis is turned and no unit guessed
};

/// Checked by checkRiggedMesh(). At most four weights per vertex, normalised; vertices without weights in a
/// rigged mesh hang on their object's node. Parts of the surface with the same look follow each other.
/// kUnreadable: missing, damaged, of another format; kUnusable: no triangle, or too large.
Result<RiggedMesh> importMesh(const std::string& path, const MeshImportSettings& settings = {});

/// Whether a file's name ends as one of the formats that can be read, in any case.
bool isMeshFileName(const std::string& path);

}  // namespace noctule
