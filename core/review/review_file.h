// SPDX-License-Identifier: Apache-2.0
// A take opened for reading what the screens show of one of its suits: sample numbers as seconds of the take,
// trouble as sentences.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/processing/take_markers.h"
#include "core/recording/take.h"
#include "core/review/take_review.h"

namespace noctule {

/// The take, open and looking at the suit of `view`; and the people in it.
struct ViewedTake {
    Take take;
    std::vector<TakeSubject> subjects;
    int suit;
    MarkerClock markers;

    static Result<ViewedTake> open(const TakeView& view);
};

/// The take and the clock of the suit in view; kUnusable without a sample rate.
struct ReviewFile {
    Take take;
    int suit;
    double sample_rate_hz = 0;
    SuitClock clock;

    static Result<ReviewFile> open(const TakeView& view);
    double seconds(double sample) const { return clock.takeTime_s(sample / sample_rate_hz); }
    double sampleAt(double t_s) const { return clock.suitTime_s(t_s) * sample_rate_hz; }
};

/// Looks at the cancel flag every few thousand rows and tells the progress by the time that was reached.
class RowProgress {
public:
    RowProgress(const JobContext& job, std::string stage, double duration_s)
        : job_(job), stage_(std::move(stage)), duration_s_(duration_s) {}
    /// False when cancelled.
    bool at(double t_s) {
        if (rows_++ % 4096 != 0)
            return true;
        if (duration_s_ > 0)
            job_.progress(std::clamp(t_s / duration_s_, 0.0, 1.0), stage_);
        return !job_.cancelled();
    }

private:
    const JobContext& job_;
    std::string stage_;
    double duration_s_;
    int64_t rows_ = 0;
};

}  // namespace noctule
