// SPDX-License-Identifier: Apache-2.0
// A figure as binary glTF 2.0, through assimp: one mesh with its skin, a primitive and a material for each
// look of its surface, the joints as nodes under it in the bind pose, and the motion as one animation with
// the clip's name. Metres and seconds, as glTF has them.
#pragma once

#include <string>

#include "core/formats/figure.h"
#include "core/job/job.h"

namespace noctule {

/// Writes aside, reads back through assimp, compares (scene_check.h) and only then gives the file its name.
Status writeGlb(const std::string& path, const Figure& figure, bool overwrite, const JobContext& job = {});

/// A body alone in its bind pose, which is the zero pose of `skeleton`. kUsage when the file exists and may
/// not be replaced, kDisk when it cannot be written.
Status writeSkinnedMesh(const std::string& path, const SkinnedMesh& mesh, const Skeleton& skeleton,
                        bool overwrite);

}  // namespace noctule
