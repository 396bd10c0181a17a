// SPDX-License-Identifier: Apache-2.0
// FBX, binary 7.4: a skeleton of limb nodes under one node, its motion as one animation stack with the
// clip's name (or several, one for each take), and where there is a body its mesh, skin and bind pose. Y up,
// facing +Z, X to the left; the file states unit and frame rate. Where the figure knows it, every bone has a
// number "confidence" with a curve, 0 to 1. No program's own library stands behind it; the layout is that of
// files other programs write.
#pragma once

#include <span>
#include <string>

#include "core/formats/fbx_scene.h"

namespace noctule {

/// The file's bytes: joints, body and rest of the first figure, a stack for the motion of each. kUnusable
/// when the others do not have its joints, places of joints and frame rate, when two have one name, and
/// beyond 4 GiB; `where` names the file.
Result<std::string> formatFbx(std::span<const Figure> figures, const FbxOptions& options,
                              const std::string& where);

/// Writes aside, reads back through assimp, compares (scene_check.h) and only then gives the file its name.
Status writeFbx(const std::string& path, std::span<const Figure> figures, const FbxOptions& options,
                bool overwrite);
inline Status writeFbx(const std::string& path, const Figure& figure, const FbxOptions& options,
                       bool overwrite) {
    return writeFbx(path, {&figure, 1}, options, overwrite);
}

}  // namespace noctule
