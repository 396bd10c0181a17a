// SPDX-License-Identifier: Apache-2.0
// Textures of bodies, made ready to be drawn. Files of others are only decoded in noctule-read-mesh.
#pragma once

#include <optional>
#include <string>

#include "core/mesh/rigged_mesh.h"

namespace noctule {

/// Decodes a texture's PNG or JPEG, made smaller until no side is longer than `side_px`. What cannot be
/// decoded stays without pixels.
void decodeTexture(SurfaceTexture& texture, int side_px = MeshLimits::kTextureSide_px);

/// Why textures of a mesh that was read have no pixels, and what to do; nothing where all have theirs.
/// `where` names its file.
std::optional<Error> undrawnTextures(const RiggedMesh& mesh, const std::string& where);

}  // namespace noctule
