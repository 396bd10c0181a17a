// SPDX-License-Identifier: Apache-2.0
// The last seconds of what a device told while it streams, so that a take can begin before the moment at
// which somebody wished for it. Sound is held by reference, the last `hold_samples` of it and little more.
// Not for several threads at once.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "devices/live/stream_event.h"

namespace noctule {

class StreamPast {
public:
    explicit StreamPast(int64_t hold_samples) : hold_samples_(hold_samples) {}

    void add(const StreamEvent& event);
    /// One after the last sample that came.
    int64_t endSample() const { return end_sample_; }
    /// Where a stream begins that shall hold this sample: with its block or, where sound is missing or
    /// forgotten, with the next.
    int64_t boundaryAt(int64_t sample) const;
    /// What a stream that begins there has to be told: how the suit was before, pulses announced before
    /// (also older ones), then everything as it came.
    std::vector<StreamEvent> since(int64_t first_sample) const;

private:
    /// What a later beginning has to know of events before it.
    struct Earlier {
        std::optional<link::BoxStatus> status;  ///< the last
        link::Pulses pulses;

        void note(const StreamEvent& event);
    };
    const ArrivedBlock& oldestBlock() const;
    void forgetOldestBlock();

    int64_t hold_samples_, held_samples_ = 0, end_sample_ = 0;
    std::deque<StreamEvent> events_;
    Earlier forgotten_;
};

}  // namespace noctule
