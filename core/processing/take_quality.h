// SPDX-License-Identifier: Apache-2.0
// What a take's boards and source-board pairs delivered: for evaluate and inspect.
#pragma once

#include <vector>

#include "core/job/job.h"
#include "core/processing/line_of_sight.h"
#include "core/recording/take.h"
#include "core/report/report_data.h"

namespace noctule {

/// Of every board, from the inertial rows of a run. Each owes frames at its own rate, as its readings'
/// instants tell it, from the first reading of any board to the last, but for one frame that the end of the
/// take cuts. They owe the readings that the format sends, from when every axis can be known. Clipped ones
/// count from then on too.
Result<std::vector<ReportBoard>> boardQuality(const Take& take, const Suit& suit,
                                              const Calibration& calibration, int64_t inertial_run);

/// What became of every pulse at every board, from the range rows of a run; without a run nothing was heard.
/// `motion` and `sight` (both or neither) tell what the pose explains.
Result<std::vector<ReportPair>> pairQuality(const Take& take, const Suit& suit,
                                            std::optional<int64_t> range_run, const PoseSource* motion,
                                            LineOfSight* sight, const JobContext& job);

}  // namespace noctule
