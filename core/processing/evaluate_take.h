// SPDX-License-Identifier: Apache-2.0
// A processed take judged: its runs against a reference, and what its pulses and boards delivered, as data
// for the report and for evaluationJson().
#pragma once

#include <optional>
#include <string>

#include "core/job/job.h"
#include "core/processing/reference_motion.h"
#include "core/report/report_data.h"

namespace noctule {

struct EvaluateRequest {
    std::string take_path;
    std::string run;                         ///< empty: the last pose run
    std::optional<int64_t> run_number;       ///< instead of the name, which several runs may share
    std::optional<OutsideMotion> reference;  ///< on a clock of its own; none: the reference in the take
    std::string reference_name;              ///< its file
    std::optional<int> suit;                 ///< whose poses, by the first suit; none: the first subject
    bool all_runs = false;                   ///< compare every run, for the report; else only the shown one
};

/// Without any reference the comparison is absent and a warning says so. kUnusable when the take holds no
/// pose run, or the reference shares no joint or time with it.
Result<ReportData> evaluateTake(const EvaluateRequest& request, const JobContext& job);

}  // namespace noctule
