// SPDX-License-Identifier: Apache-2.0
// FBX, binary 7.4: a skeleton of limb nodes under one node, its motion as one animation stack with the
// clip's name (or several, one for each take), and where there is a body its mesh, skin and bind pose; or
// several such characters that share the stack, each under a node with its name. Y up,
// facing +Z, X to the left; the file states unit and frame rate. Where the figure knows it, every bone has a
// number "confidence" with a curve, 0 to 1. No program's own library stands behind it; the layout is that of
// files other programs write.
#pragma once

#include <string>

#include "core/formats/fbx_scene.h"
#include "core/job/job.h"

namespace noctule {

/// Joints, body and rest of the first figure, a stack for the motion of each; of figures with a character
/// (Figure::character) joints and body of each, and one stack. Written aside, read back through assimp,
/// compared with what `figures` gives when it is asked again (scene_check.h), and only then given its name.
/// kUnusable when the others do not have the frame rate of the first and, without characters, its joints and
/// their places, when two have one name, and beyond 4 GiB. A cancel is seen between figures, and between
/// frames of the check.
///
/// In memory at once: the bytes of the file (12 to a key) and one figure; while it is read back, in their
/// place what assimp makes of it, about ten times as much.
Status writeFbx(const std::string& path, const FigureSource& figures, const FbxOptions& options,
                bool overwrite, const JobContext& job = {});
/// A file of one motion.
inline Status writeFbx(const std::string& path, const Figure& figure, const FbxOptions& options,
                       bool overwrite, const JobContext& job = {}) {
    return writeFbx(path, sourceOf({&figure, 1}), options, overwrite, job);
}

}  // namespace noctule
