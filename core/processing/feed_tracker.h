// SPDX-License-Identifier: Apache-2.0
// The primary readings and ranges of one suit, merged by time, into a tracker.
#pragma once

#include <functional>

#include "core/job/job.h"
#include "core/live/motion_tracker.h"
#include "core/processing/ingredients.h"
#include "core/recording/take.h"

namespace noctule {

struct FedFrames {
    int64_t seen = 0, lost = 0;
};

/// `collect` is called ten times a second of the take: poses and ranges can be taken out; it is given the
/// sample that has been reached.
Result<FedFrames> feedTracker(const Take& take, const Ingredients& in, MotionTracker& tracker,
                              const std::function<Status(int64_t)>& collect, const JobContext& job);

}  // namespace noctule
