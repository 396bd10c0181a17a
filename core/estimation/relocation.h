// SPDX-License-Identifier: Apache-2.0
// Where a body is after its whole suit was silent, as when the link broke off in the midst of a movement.
//
// A limb may have turned by tens of degrees since. Linearised about the last estimate, the first readings
// turn it somewhere else and make the filter sure of that. So they are looked at together. The most likely
// motion through them is found (MapProblem, with the filter's own prior and decisions), and the filter is
// linearised about it. Its covariance stays that of what was known before, so sigmas tell what the readings
// tell.
#pragma once

#include <vector>

#include "core/estimation/manifold_filter.h"

namespace noctule {

/// What each of the next steps, whose inputs are `ahead`, is to be linearised about; empty where no motion
/// was found. `filter`: a copy, which refers to the skeleton and the suit of the original.
std::vector<ManifoldFilter::StepInput::About> relocate(ManifoldFilter filter,
                                                       std::vector<ManifoldFilter::StepInput> ahead);

}  // namespace noctule
