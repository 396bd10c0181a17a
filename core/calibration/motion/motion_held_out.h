// SPDX-License-Identifier: Apache-2.0
// Cross-validation of a calibration from motion (Stone 1974): the constants found on most of the movement
// are tried on seconds that were held out, board by board, against those of the rest pose. A least-squares
// fit always explains what it was fitted to better than its start; only other seconds show that a board that
// the movement hardly shows was turned to fit tissue and joints.
#pragma once

#include "core/calibration/motion/motion_fit.h"

namespace noctule {

/// The nodes from `from` on up to `to` of a take, after its first rest pose; what straddles the seam between
/// the two is not heard. `nodes`: the take's trajectory, replaced by that of the slice.
MotionEvidence slicedEvidence(const MotionEvidence& evidence, int from, int to,
                              std::vector<MotionNode>& nodes);

/// Per board: cost of the seconds held out with the constants learnt on the others, divided by their cost
/// with those of the rest pose; above 1: the rest pose's are better. 1 where nothing was held out.
struct HeldOutCheck {
    std::vector<double> cost_ratio{};
};

struct HeldOutProblem {
    const MotionBody& body;
    const MotionModel& model;
    const MotionLayout& layout;
    const MotionSettings& settings;
    const std::vector<MotionEvidence>& takes;
    const ExpectedConstants& expected;
    const MotionUnknowns& rest_pose;  ///< constants before the movement
    const MotionUnknowns& found;      ///< of all seconds; the fits begin with its trajectory
};

Result<HeldOutCheck> checkOnHeldOut(const HeldOutProblem& problem, const JobContext& job);

}  // namespace noctule
