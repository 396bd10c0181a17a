// SPDX-License-Identifier: Apache-2.0
// Which explanation of a still stretch is the most likely: everything where the suit says, two boards
// exchanged (with their calibration: worn the one as the other; without: at their plugs), a board or a source
// far from its place. Every hypothesis is a fit of the rest pose; the best is accepted when it gains enough,
// and the search goes on from there.
#pragma once

#include <vector>

#include "core/calibration/rest_pose/rest_evidence.h"
#include "core/calibration/rest_pose/rest_pose_calibration.h"
#include "core/calibration/rest_pose/rest_sight.h"

namespace noctule {

struct RestExplanation {
    Arrangement arrangement;
    RestPriors priors;
    RestEvidence evidence;
    RestFit fit;
    double cost = 0;  ///< of fit, readings and lines of sight
    std::vector<SwappedBoards> swapped, rivals, untold;
    std::vector<int> shifted_boards, shifted_sources;
};

/// Error: kCancelled alone.
Result<RestExplanation> explainRest(const RestPoseFit& fitter, const RestEvidenceMaker& maker,
                                    const RestSight& sight, const RestPriors& priors, const JobContext& job);

}  // namespace noctule
