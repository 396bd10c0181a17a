// SPDX-License-Identifier: Apache-2.0
// Frames in which a capture lost its subject. Programs write zeros there: the figure falls back into its zero
// pose at the origin. Such frames are bridged between their neighbours, at the ends of the file they are cut
// off, and all are counted.
#pragma once

#include <string>
#include <vector>

#include "core/motion/clip.h"

namespace noctule::figure {

struct LostTracking {
    size_t cut_first = 0, cut_last = 0;                  ///< frames of zeros at the beginning and at the end
    size_t bridged = 0;                                  ///< frames of zeros in between
    size_t longest = 0;                                  ///< of these, in a row
    std::vector<std::pair<std::string, size_t>> joints;  ///< zeros of one joint alone, and in how many frames

    bool any() const { return cut_first + cut_last + bridged > 0 || !joints.empty(); }
};

/// kUnusable when more than half of the frames are lost.
Result<LostTracking> bridgeLostTracking(MotionClip& clip);

}  // namespace noctule::figure
