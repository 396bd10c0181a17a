// SPDX-License-Identifier: Apache-2.0
// BROAD's measure of orientation (Laidig et al. 2021, section 4): root mean square of total, heading and
// inclination error over the phases of movement.
#pragma once

#include <span>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

struct OrientationScore {
    double total_deg = 0, heading_deg = 0, inclination_deg = 0;
    double heading_offset_deg = 0;  ///< the constant turn about the vertical taken off the estimate first
    size_t samples = 0;             ///< compared; 0: nothing to compare, all else is 0
};

/// `reference` and `estimate` are q_world_sensor of the same instants. Rows whose reference is not finite, or
/// whose `counts` is 0, are left out; an empty `counts` counts all. The heading is turned once by its best
/// constant, as two systems seldom agree on north.
OrientationScore scoreOrientation(std::span<const Quaterniond> estimate,
                                  std::span<const Quaterniond> reference, const std::vector<char>& counts);

}  // namespace noctule
