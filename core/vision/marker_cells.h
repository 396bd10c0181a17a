// SPDX-License-Identifier: Apache-2.0
// The picture of one marker: 6 x 6 cells, the outer ones black.
#pragma once

#include <array>

namespace noctule {

inline constexpr int kMarkerCells = 6;     ///< along a side
inline constexpr int kMarkerNumbers = 50;  ///< 0..49

/// Rows from the top, true is white.
using MarkerCells = std::array<std::array<bool, kMarkerCells>, kMarkerCells>;

MarkerCells markerCells(int number);

}  // namespace noctule
