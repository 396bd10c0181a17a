// SPDX-License-Identifier: Apache-2.0
#include "core/processing/feed_tracker.h"

#include <algorithm>

#include "core/body/text.h"
#include "core/job/limits.h"

namespace noctule {
namespace {

Error holeOfReadings(const Take& take, double from_sample, double to_sample, double sample_rate_hz) {
    const auto at = [&](double sample) { return text::clock(sample / sample_rate_hz); };
    return {ErrorKind::kUnusable,
            take.path() + ": there is no reading from " + at(from_sample) + " to " + at(to_sample) +
                ", and no pose can be carried over that",
            "Record or import it as two takes; if the take is damaged, correct the instants of its readings"};
}

}  // namespace

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
    const auto hole = static_cast<double>(limits::kLongestHole_s * kPortions_per_s * portion);
    int64_t watermark = 0;
    double last_sample = -1;
    // Ranges go with their arrival, which lies after the pulse: none that belongs before is still to come.
    const auto advance = [&](int64_t to, bool at_end) -> Status {
        watermark = to;
        while (*range && (at_end || (*range)->pulse_sample < watermark)) {
            tracker.add(**range);
            range = ranges->next();
            if (!range)
                return range.error();
        }
        if (at_end)
            tracker.end();
        tracker.advanceTo(watermark);
        if (Status done = collect(watermark); !done)
            return done;
        return job.cancelled() ? Status(JobContext::cancelledError()) : Done{};
    };
    while (true) {
        auto reading = readings->next();
        if (!reading)
            return reading.error();
        const bool ended = !reading->has_value();
        const bool is_last_heard = ended && last_sample >= 0 && !*range;
        const double sample = !ended ? (*reading)->sample
                              : is_last_heard
                                  ? std::min(static_cast<double>(in.sample_count), last_sample + hole)
                                  : static_cast<double>(in.sample_count);
        if (!ended && last_sample >= 0 && sample > last_sample + hole)
            return holeOfReadings(take, last_sample, sample, in.decoder.train.sample_rate_hz);
        const int64_t reached = std::max(static_cast<int64_t>(sample), watermark);
        if (ended || reached >= watermark + portion) {
            while (watermark + 2 * portion <=
                   reached)  // in steps over a hole, so that it can be cancelled there
                if (Status done = advance(watermark + portion, false); !done)
                    return done.error();
            if (Status done = advance(reached, ended); !done)
                return done.error();
        }
        if (ended)
            return frames;
        last_sample = sample;
        frames.seen += 1;
        frames.lost += (*reading)->corrected_bits ? 0 : 1;
        tracker.add(**reading);
    }
}

}  // namespace noctule
