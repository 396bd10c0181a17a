// SPDX-License-Identifier: Apache-2.0
// A take as it is processed, against its reference.
#pragma once

#include "core/processing/evaluate_take.h"
#include "core/processing/process_take.h"

namespace noctule {

/// The take's own calibration and actor unless others are given.
inline Comparison processedAndCompared(const std::string& take_path, const TrackerSettings& tracker,
                                       const std::optional<Calibration>& calibration = {},
                                       const std::optional<Actor>& actor = {}) {
    ProcessRequest request;
    request.take_path = take_path;
    request.tracker = tracker;
    request.calibration = calibration;
    request.actor = actor;
    request.created_utc = "2000-01-01T00:00:00Z";
    EvaluateRequest evaluation;
    evaluation.take_path = take_path;
    evaluation.run_number = processTake(request, {}).value().pose_run;
    const ReportData judged = evaluateTake(evaluation, {}).value();
    for (const ReportRun& run : judged.runs)
        if (run.is_shown && run.comparison)
            return *run.comparison;
    return {};
}

}  // namespace noctule
