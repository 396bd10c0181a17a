// SPDX-License-Identifier: Apache-2.0
// Figures as binary glTF 2.0, through assimp. Each is one mesh with its skin, and has a primitive and a
// material for each look of its surface. Its joints are nodes in the bind pose. A motion is an animation with
// the clip's name; several takes are several animations. Several characters each stand under a node with
// their name and share one animation. Metres and seconds, as glTF has them.
#pragma once

#include <string>

#include "core/formats/figure.h"
#include "core/job/job.h"

namespace noctule {

/// Figures share a file as in writeFbx(); those that cannot are kUnusable (figures_in_file.h), and so is a
/// file beyond 4 GiB. Written aside, read back through assimp, compared (scene_check.h), and only then given
/// its name. In memory at once: the file twice and one figure; while it is read back, what assimp makes of
/// it.
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
