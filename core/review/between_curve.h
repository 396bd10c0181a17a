// SPDX-License-Identifier: Apache-2.0
// How far two people of a take are from each other over its time: hand to hand, pelvis to pelvis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/review/joint_curves.h"
#include "core/review/take_review.h"

namespace noctule {

struct BetweenTrack {
    std::string joint, other_joint;  ///< of the one and of the other
    double least_m = 0;              ///< the shortest distance of the take
    /// Distance in metres. Its band is -+ 2 sigma along the line that joins them, where the run says how sure
    /// it is of that vector (table relative); else there is none.
    MotionCurve distance;
};

/// Every pair of kComparedEnds (processing/evaluate_between.h) that both bodies have. The take states its
/// uncertainty for the earlier of two subjects: `view` looks at that one's suit. `run`: a pose run that holds
/// both; absent: the references.
Result<std::vector<BetweenTrack>> loadBetween(const TakeView& view, std::optional<int64_t> run,
                                              int other_suit, const JobContext& job);

/// The pair, other than the pelvises, that comes nearest in the take; null when there is none.
const BetweenTrack* nearestHands(const std::vector<BetweenTrack>& tracks);

}  // namespace noctule
