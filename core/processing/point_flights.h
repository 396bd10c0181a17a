// SPDX-License-Identifier: Apache-2.0
// Ranges of a take of several suits with both instants on common time: what points are tracked from.
#pragma once

#include <string>
#include <vector>

#include "core/estimation/rest_alignment.h"
#include "core/processing/cross_clocks.h"
#include "core/processing/cross_ranges.h"
#include "core/processing/ingredients.h"

namespace noctule {

/// One range. `from` and `to` are members: subjects, then the room.
struct PointFlight {
    double emission_s = 0, duration_s = 0;
    int from = 0, source = 0, to = 0, board = 0;
    double distance_m = 0, sigma_m = 0;
};

/// In the order of their emissions; those to moved anchors and those hardly believed are left out. Clocks of
/// `clocks` where all members have one, else those of `alignment`, which a warning says.
Result<std::vector<PointFlight>> pointFlights(const Take& take, const std::vector<Ingredients>& subjects,
                                              const Joining& joining, const RestAlignment& alignment,
                                              const TakeClocks& clocks, std::vector<std::string>& warnings);

}  // namespace noctule
