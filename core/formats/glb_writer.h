// SPDX-License-Identifier: Apache-2.0
// Figures as binary glTF 2.0, through assimp: one mesh with its skin, a primitive and a material for each
// look of its surface, the joints as nodes under it in the bind pose, and the motion as one animation with
// the clip's name (or several, one for each take); or several such characters, each under a node with its
// name, that share the animation. Metres and seconds, as glTF has them.
#pragma once

#include <string>

#include "core/formats/figure.h"
#include "core/job/job.h"

namespace noctule {

/// Figures share a file as in writeFbx(), and for the same reasons are kUnusable (figures_in_file.h). Written
/// aside, read back through assimp, compared (scene_check.h), and only then given its name. In memory at
/// once: the file twice and one figure.
Status writeGlb(const std::string& path, const FigureSource& figures, bool overwrite,
                const JobContext& job = {});
/// A file of one motion.
inline Status writeGlb(const std::string& path, const Figure& figure, bool overwrite,
                       const JobContext& job = {}) {
    return writeGlb(path, sourceOf({&figure, 1}), overwrite, job);
}

/// A body alone in its bind pose, which is the zero pose of `skeleton`. kUsage when the file exists and may
/// not be replaced, kDisk when it cannot be written.
Status writeSkinnedMesh(const std::string& path, const SkinnedMesh& mesh, const Skeleton& skeleton,
                        bool overwrite);

}  // namespace noctule
