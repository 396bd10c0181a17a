// SPDX-License-Identifier: Apache-2.0
// Processing of several subjects, or of one and the anchors of its room, as one estimate.
#pragma once

#include "core/processing/result_runs.h"

namespace noctule {

/// False, and nothing written: nothing joins the subjects, or it was not wanted; each is to be processed by
/// itself.
Result<bool> processTogether(Take& take, const ProcessRequest& request, const TrackerSettings& settings,
                             std::vector<Ingredients>& subjects, ResultRuns& results, const JobContext& job);

}  // namespace noctule
