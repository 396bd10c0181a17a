// SPDX-License-Identifier: Apache-2.0
// Which printed marker stands for what: ArUco 4x4_50, sources from 0, boards from 10, 49 for the jig's
// origin, which belongs to no part and only ties photographs together.
#pragma once

#include <string>
#include <vector>

#include "core/suit/suit.h"

namespace noctule {

struct PlannedMarker {
    enum class Kind { kSource, kBoard, kOrigin } kind = Kind::kOrigin;
    int number = 0;
    int part = 0;         ///< index in the suit's sources or boards
    std::string id = {};  ///< of the part; empty: the origin
    std::string name;     ///< "source 2, chest_r", "board 7, l_forearm", "origin"

    bool operator==(const PlannedMarker&) const = default;
};

inline constexpr int kFirstSourceMarker = 0, kFirstBoardMarker = 10, kOriginMarker = 49;

/// Sources, boards, origin. kUnusable when the suit has more parts than there are markers.
Result<std::vector<PlannedMarker>> planMarkers(const Suit& suit);

}  // namespace noctule
