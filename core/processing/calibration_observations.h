// SPDX-License-Identifier: Apache-2.0
// A take's sound or readings as the solvers of calibration want them.
#pragma once

#include "core/acoustics/pulse_detector.h"
#include "core/calibration/observations.h"
#include "core/job/job.h"
#include "core/recording/take.h"

namespace noctule {

/// `calibration` and `actor`: instead of those in force in the take. kUnusable when the take's suit and sound
/// contradict each other. The whole take lies in memory: some 40 bytes for each of 140 frames a second and
/// board, as much for each range.
Result<Observations> readObservations(const Take& take, Detector detector, const JobContext& job,
                                      const std::optional<Calibration>& calibration = {},
                                      const std::optional<Actor>& actor = {});

}  // namespace noctule
