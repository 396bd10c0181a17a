// SPDX-License-Identifier: Apache-2.0
#include "core/processing/feed_tracker.h"

#include <algorithm>

namespace noctule {

Result<FedFrames> feedTracker(const Take& take, const Ingredients& in, MotionTracker& tracker,
                              const std::function<Status(int64_t)>& collect, const JobContext& job) {
    FedFrames frames;
    auto readings = take.readings(kPrimaryRun, in.subject.suit());
    if (!readings)
        return readings.error();
    auto ranges = take.ranges(kPrimaryRun, in.subject.suit());
    if (!ranges)
        return ranges.error();
    auto range = ranges->next();
    if (!range)
        return range.error();
    constexpr int64_t kPortions_per_s = 10;
    const auto portion = static_cast<int64_t>(in.decoder.train.sample_rate_hz) / kPortions_per_s;
    int64_t watermark = 0;
    while (true) {
        auto reading = readings->next();
        if (!reading)
            return reading.error();
        const bool ended = !reading->has_value();
        const double sample = ended ? 0 : (*reading)->sample;
        if (ended || sample >= static_cast<double>(watermark + portion)) {
            watermark = ended ? std::max(in.sample_count, watermark) : static_cast<int64_t>(sample);
            // Ranges go with their arrival, which lies after the pulse: none that belongs before is still to
            // come.
            while (*range && (ended || (*range)->pulse_sample < watermark)) {
                tracker.add(**range);
                range = ranges->next();
                if (!range)
                    return range.error();
            }
            tracker.advanceTo(watermark);
            if (Status done = collect(watermark); !done)
                return done.error();
            if (job.cancelled())
                return JobContext::cancelledError();
        }
        if (ended)
            return frames;
        frames.seen += 1;
        frames.lost += (*reading)->corrected_bits ? 0 : 1;
        tracker.add(**reading);
    }
}

}  // namespace noctule
