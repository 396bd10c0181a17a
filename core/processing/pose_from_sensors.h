// SPDX-License-Identifier: Apache-2.0
// Poses of a suit of independent inertial sensors: each sensor's orientation, then the body's pose
// (core/posing). It needs the whole take, so it does not run through the live pipeline.
#pragma once

#include "core/processing/result_runs.h"

namespace noctule {

/// Reads the suit in view and writes poses and contacts. kUnusable: no sensor with readings or attitudes.
Status poseFromSensors(const Take& take, const Ingredients& in, const TrackerSettings& tracker,
                       ResultRuns& results, const JobContext& job);

}  // namespace noctule
