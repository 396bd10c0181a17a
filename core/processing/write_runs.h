// SPDX-License-Identifier: Apache-2.0
// One processing of a take from its file to its derived runs: which subjects, what each is made with, and all
// of it written at once.
#pragma once

#include <functional>

#include "core/processing/result_runs.h"

namespace noctule {

/// Gives everything that the processing of one subject, whose suit is in view, yields to the runs.
using FillRuns = std::function<Status(const Take& take, const Ingredients& in, ResultRuns& runs)>;
/// Gives what the processing of all subjects together yields; false: nothing joins them, each is to be
/// processed by itself.
using FillTogether =
    std::function<Result<bool>(Take& take, std::vector<Ingredients>& subjects, ResultRuns& runs)>;

/// Everything or nothing: when filling fails or yields no pose, the take stays as it was. Reads in one
/// snapshot; another program that writes the take meanwhile is waited for, at most an hour.
Result<ProcessSummary> writeRuns(const ProcessRequest& request, const FillRuns& fill,
                                 const CancelFlag* cancel = nullptr, const FillTogether& together = {});

}  // namespace noctule
