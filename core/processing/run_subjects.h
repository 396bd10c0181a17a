// SPDX-License-Identifier: Apache-2.0
// Whose poses a run holds, and an export of each.
#pragma once

#include "core/processing/export_take.h"
#include "core/recording/take.h"

namespace noctule {

/// The take's subjects of whom the pose run of that name (empty: the last one) holds poses; at least one.
/// Errors as those of choosePoseRun().
Result<std::vector<TakeSubject>> subjectsOfRun(const std::string& take_path, const std::string& run);

/// "walk_A.bvh" of "walk.bvh". What a file's name cannot hold becomes an underscore.
std::string pathOfSubject(const std::string& path, const std::string& subject);

/// The same export for each subject of its run; where there are several, files are called "walk_A.bvh"
/// instead of "walk.bvh". Their frames are at the same instants, from whoever is seen first to whoever is
/// seen last; the others hold their first and last poses (held_pose.h).
Result<std::vector<ExportRequest>> requestsOfSubjects(const ExportRequest& request);

/// The same export with all subjects of its run as characters of one FBX or GLB file (exportStacks()), at the
/// same instants as well. A single subject gives the request as it is. kUnusable when one is never seen.
Result<std::vector<ExportRequest>> requestsTogether(const ExportRequest& request);

}  // namespace noctule
