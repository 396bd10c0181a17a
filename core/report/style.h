// SPDX-License-Identifier: Apache-2.0
// The report's style sheet: the studio's colours in light and dark (as the reader's system prefers; paper is
// always light), its type sizes and spaces.
#pragma once

#include <string>

namespace noctule {

std::string styleSheet();

/// Confidence 0..1 -> class "c0".."c20", coloured by the studio's confidence scale.
std::string confidenceClass(double confidence);

}  // namespace noctule
