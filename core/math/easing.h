// SPDX-License-Identifier: Apache-2.0
// From nothing to the whole without a jerk.
#pragma once

#include <algorithm>

namespace noctule {

/// 0 to 1 as `share` goes from 0 to 1, level at both ends and beyond (the cubic Hermite step).
inline double eased(double share) {
    const double x = std::clamp(share, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

}  // namespace noctule
