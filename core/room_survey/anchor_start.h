// SPDX-License-Identifier: Apache-2.0
// First places of anchors from ranges alone. What the room's file says takes no part, so that it may be wrong
// by metres: an anchor is placed from many starts by the ranges to a performer's devices or to anchors that
// are placed already; without a performer all are placed by multidimensional scaling of their distances.
#pragma once

#include <optional>

#include "core/room_survey/evidence.h"

namespace noctule::room_survey {

inline constexpr size_t kFewestAnchors = 3;
inline constexpr int kFewestRanges = 12;  ///< between the performer and an anchor

struct AnchorStart {
    std::vector<std::optional<Vector3d>> places_m;  ///< none: too few ranges
    std::vector<char> is_mirrored;  ///< a second place fits as well, most often its mirror image
    double clock_m = 0;             ///< by which ranges are too long where an anchor hears
};

/// In the world of the poses, as they are at the beginning.
AnchorStart startFromWalk(const Evidence& evidence);

/// In a frame of its own: the distances hold neither place nor turn, nor which of two mirror images it is.
/// Distances that were not measured are the shortest ways over others.
AnchorStart startFromDistances(const Evidence& evidence);

/// Robust mean of one pair's ranges in both directions; nothing when it was never heard.
struct PairDistance {
    int a = 0, b = 0, count = 0;
    double distance_m = 0, sigma_m = 0;
    double apart_m = 0;  ///< of the two directions; an echo makes one longer
};
std::vector<PairDistance> pairDistances(const Evidence& evidence);

}  // namespace noctule::room_survey
