// SPDX-License-Identifier: Apache-2.0
// Photographs of the jig from file to distances: the suit and the placements' labels are the takes', the
// files' names say which placement they show.
#pragma once

#include <string>
#include <vector>

#include "core/vision/marker_photographs.h"

namespace noctule {

struct JigPhotographs {
    std::vector<std::string> take_paths;  ///< of one suit
    std::vector<std::string> photograph_paths;
    PhotographSettings settings;
};

/// kUsage: a file's name without a placement; kUnreadable: no photograph; kUnusable: no distance comes out of
/// them all.
Result<PhotographedDistances> measureJigPhotographs(const JigPhotographs& request, const JobContext& job);

}  // namespace noctule
