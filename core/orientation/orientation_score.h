// SPDX-License-Identifier: Apache-2.0
// BROAD's measure of orientation (Laidig et al. 2021, section 4): root mean square of total, heading and
// inclination error over the phases of movement.
#pragma once

#include <span>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

struct OrientationScore {
    double total_deg = 0, heading_deg = 0, inclination_deg = 0;  ///< as they are, which is BROAD's measure
    double heading_offset_deg = 0;                        ///< the estimate's mean turn about the vertical
    double total_turned_deg = 0, heading_turned_deg = 0;  ///< with that turn taken off the estimate
    size_t samples = 0;                                   ///< compared; 0: nothing to compare, all else is 0
};

/// `reference` and `estimate` are q_world_sensor of the same instants. Rows whose reference is not finite, or
/// whose `counts` is 0, are left out; an empty `counts` counts all. Compare sensors without
/// magnetometers, whose north is arbitrary, by the turned errors.
OrientationScore scoreOrientation(std::span<const Quaterniond> estimate,
                                  std::span<const Quaterniond> reference, const std::vector<char>& counts);

}  // namespace noctule
