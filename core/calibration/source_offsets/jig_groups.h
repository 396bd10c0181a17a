// SPDX-License-Identifier: Apache-2.0
// What flagged measurements of a jig have in common: one board that was hit says so once, not forty times.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/source_offsets/jig_measurements.h"

namespace noctule {

struct JigGroup {
    std::string part;             ///< id of the board or source; empty: a placement or mixed pairs
    std::string words;            ///< "board 7, l_forearm, in placement 3"
    std::vector<size_t> flagged;  ///< of the measurements
    size_t total = 0;
};

/// Greedy: the board, source or placement, or board or source in one placement, with the most flags of which
/// most of its measurements carry one; then the next. Single pairs come last, in one group.
std::vector<JigGroup> groupFlagged(const JigData& jig, std::vector<bool> flagged);

}  // namespace noctule
