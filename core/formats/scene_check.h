// SPDX-License-Identifier: Apache-2.0
// A written scene file (FBX, GLB) is opened again (scene_reader.h) and held against the figure it should
// hold: every joint in every frame, the skin in some. A file of several motions against a figure of each.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/figure.h"
#include "core/formats/scene_reader.h"
#include "core/job/job.h"

namespace noctule {

struct SceneDifference {
    size_t frames = 0;             ///< in the file
    double frames_per_second = 0;  ///< by its keys; 0 with fewer than two
    double joint_m = 0;            ///< largest distance of a joint from where it should be, in any frame
    double vertex_m = 0;           ///< the same of the skin; 0 without
};

/// What float32 explains in the figure's file, with room to spare: 25 millionths of its size (45 micrometres
/// of a person) and one of how far from the origin it gets.
double sceneLimit_m(const Figure& figure);

/// Size and hash of what is about to be written.
class WrittenBytes {
public:
    explicit WrittenBytes(std::string_view bytes);
    /// kDisk when the file holds anything else; `where` names it in errors.
    Status check(const std::string& path, const std::string& where) const;

private:
    size_t size_, hash_;
};

/// kUnreadable when the file cannot be read, or when joints, frames or triangles in it are not the figure's,
/// or no motion has its name; `where` names it in errors.
Result<SceneDifference> compareScene(const std::string& path, const std::string& where, SceneFormat format,
                                     const Figure& figure);

/// The same as a verdict: kInternal, and says which part of it, when anything is further off than
/// sceneLimit_m(); the disk is not to blame when WrittenBytes::check() found it right. The file is read once,
/// however many motions it holds. kCancelled, seen between frames but not while the file is being read.
Status checkScene(const std::string& path, const std::string& where, SceneFormat format,
                  const FigureSource& figures, const JobContext& job = {});
inline Status checkScene(const std::string& path, const std::string& where, SceneFormat format,
                         const Figure& figure, const JobContext& job = {}) {
    return checkScene(path, where, format, sourceOf({&figure, 1}), job);
}

}  // namespace noctule
