// SPDX-License-Identifier: Apache-2.0
// From what is wished of a stream and what the box said of itself to what the recorder and the processor
// need. `suit` as it is worn; `pre_roll_samples`: so much of the stream lies before the moment of the wish.
#pragma once

#include "devices/driver_box/hello.h"
#include "devices/live/stream_request.h"

namespace noctule {

/// Of sound that may wait for the disk or for the pipeline: a pre-roll comes all at once.
double queueLength_s(int64_t pre_roll_samples, int sample_rate_hz);

TakePlan takePlanOf(const StreamRequest& request, const link::Hello& hello, const Suit& suit,
                    int64_t pre_roll_samples);

/// As asked for, else as the estimator wants it and the calibration allows.
Detector detectorOf(const StreamRequest& request);

/// Fails when what the pipeline would get cannot be stored in a take either.
Result<LivePlan> livePlanOf(const StreamRequest& request, const link::Hello& hello, const Suit& worn,
                            int64_t pre_roll_samples);

}  // namespace noctule
