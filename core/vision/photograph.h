// SPDX-License-Identifier: Apache-2.0
// What one photograph shows of the markers. Pixels as the camera's chip has them, whatever way up the
// photograph is to be looked at: so upright and lying photographs of one camera share one lens.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/math/conventions.h"

namespace noctule {

struct SeenMarker {
    int number = 0;
    /// As printed: top left, top right, bottom right, bottom left; the first pixel's middle is (0, 0).
    std::array<Eigen::Vector2d, 4> corners_px;
};

struct Photograph {
    std::string name;  ///< for messages
    int width_px = 0, height_px = 0;
    std::vector<SeenMarker> markers;  ///< a number stands in it twice when it was seen twice
};

/// `bytes` is a JPEG, PNG or what else OpenCV reads. kUnreadable when it is no picture or not all of one.
Result<Photograph> findMarkers(const std::string& bytes, const std::string& name);

/// One file after the other, so that only one lies in memory.
Result<std::vector<Photograph>> readPhotographs(const std::vector<std::string>& paths, const JobContext& job);

/// The label of a photograph's placement by its file name, LABEL_*.*: the longest that fits. kUsage when none
/// does.
Result<std::string> placementOf(const std::string& path, const std::vector<std::string>& labels);

}  // namespace noctule
