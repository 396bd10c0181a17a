// SPDX-License-Identifier: Apache-2.0
// Orientation of each sensor of a take by itself: readings of run 0 in, a run of kind `orientation` out; and
// its comparison with the take's reference.
#pragma once

#include "core/job/job.h"
#include "core/orientation/orientation_estimators.h"
#include "core/orientation/orientation_score.h"
#include "core/recording/take.h"

namespace noctule {

struct OrientRequest {
    std::string take_path, run_name, created_utc, software;
    const OrientationEstimator* estimator = nullptr;
    OrientationChoice choice;
    /// In place of the one in force in the take, which stays so.
    std::optional<Calibration> calibration = std::nullopt;
};

struct OrientedBoard {
    std::string id;
    size_t readings = 0, missing = 0;
    bool has_magnetometer = false;
    double mag_lag_ms = 0, mag_lag_sigma_ms = 0;  ///< 0 when the estimator finds none
    double heading_sigma_deg = 0;                 ///< at the end
};

struct OrientSummary {
    int64_t run = 0;
    std::string run_name;
    std::vector<OrientedBoard> boards;
    std::vector<std::string> warnings;
};

/// All boards into one run, or nothing at all. kUnusable: no readings, a rate that cannot be told,
/// or a calibration of none of the boards.
Result<OrientSummary> orientTake(const OrientRequest& request, const JobContext& job);

struct OrientationEvaluation {
    std::string run_name, board;
    OrientationScore score;
};
/// Nothing when the run that `name` means (empty: the last one of any kind that can be judged) is no
/// orientation run. kUnusable when the take has no reference of one sensor.
Result<std::optional<OrientationEvaluation>> evaluateOrientation(const std::string& take_path,
                                                                 const std::string& name);

}  // namespace noctule
