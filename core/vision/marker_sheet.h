// SPDX-License-Identifier: Apache-2.0
// The markers of a suit to be printed: A4 pages as SVG in exact millimetres, each marker with its number, its
// name and a white margin of one cell, and a line of 100 mm that tells whether the printer kept the scale.
#pragma once

#include <string>
#include <vector>

#include "core/suit/suit.h"

namespace noctule {

inline constexpr double kSmallestMarker_mm = 10, kLargestMarker_mm = 120;

/// One SVG document per page: sources, boards, origin. kUnusable when the suit has more parts than there are
/// markers.
Result<std::vector<std::string>> markerSheet(const Suit& suit, double marker_mm);

}  // namespace noctule
