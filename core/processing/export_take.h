// SPDX-License-Identifier: Apache-2.0
// A processed take as animation files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/formats/figure.h"
#include "core/job/job.h"
#include "core/motion/clip.h"

namespace noctule {

/// What happens to the motion of the root.
enum class RootMotion {
    kMoving,   ///< as captured
    kInPlace,  ///< stays over the spot of the first frame; up and down and turning remain
    kHeading,  ///< in place, and turning about the vertical is taken out too: always faces forward (+Z)
};

struct ExportRequest {
    std::string take_path;
    std::string run;  ///< empty: the last pose run
    double frames_per_second = 120;
    std::optional<double> from_s, to_s;  ///< of the take's clock; the first frame stands at from_s
    RootMotion root = RootMotion::kMoving;
    std::string bvh_path, fbx_path, glb_path, csv_path, mot_path, sto_path;  ///< empty: none
    double metres_per_unit = 0.01;                                           ///< of BVH and FBX files
    JointNames names = JointNames::kOwn;                                     ///< in BVH, FBX and GLB files
    std::string root_name = "Reference";                                     ///< FBX: the node above the hips
    bool with_body = true;  ///< FBX and GLB: the default body in the performer's measures
    bool angles = false;    ///< named degrees of freedom in the CSV file too
    bool overwrite = false;
};

struct ExportSummary {
    std::string run;
    size_t frames = 0;
    double duration_s = 0;
    std::vector<std::string> files;
};

/// The files that a request asks for.
std::vector<std::string> outputsOf(const ExportRequest& request);

/// Every file is written aside, read back where that is possible, and renamed.
Result<ExportSummary> exportTake(const ExportRequest& request, const JobContext& job);

}  // namespace noctule
