// SPDX-License-Identifier: Apache-2.0
// What a device tells while it streams, handed to the recorder and to the processor in the terms of take
// files and on the clock of the take, whose sample 0 may lie anywhere in the device's stream. Never waits.
#pragma once

#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

#include "core/recording/pulse_rate.h"
#include "devices/live/live_processor.h"
#include "devices/live/recorder.h"
#include "devices/live/stream_event.h"

namespace noctule {

class StreamFeed {
public:
    struct Clock {
        int sample_rate_hz = 150000;
        int64_t origin = 0;  ///< the device's sample that is 0 here; no block begins before it and ends after
    };
    /// Either of the two may be absent.
    StreamFeed(std::shared_ptr<Recorder> recorder, std::shared_ptr<LiveProcessor> processor, int board_count,
               const Clock& clock);

    void take(const StreamEvent& event);
    // What the operator adds.
    /// At the newest sample, or at one that has come already.
    void addMarker(const std::string& kind, const std::string& label, std::optional<int64_t> sample = {});
    void addNote(const std::string& text);
    /// What has not come until there will not come any more: a gap, and reachedSample() is there.
    void markMissing(int64_t until, const std::string& reason);
    /// The stream has ended: what was held back is handed on.
    void flush();

    /// Whole sentences: the first few errors of the box.
    std::vector<std::string> boxWarnings();

    /// One after the last sample that came.
    int64_t reachedSample() const { return reached_sample_; }
    /// The device's sample that is 0 here.
    int64_t origin() const { return clock_.origin; }
    /// The device's time that is 0 here.
    int64_t origin_ns() const {
        return std::llround(static_cast<double>(clock_.origin) * 1e9 / clock_.sample_rate_hz);
    }

private:
    struct Silence {  ///< of one board
        int64_t first_sample = 0, sample_count = 0;
    };
    void give(const ArrivedBlock& block);
    void give(const link::Pulses& pulses);
    void give(const link::Gap& gap);
    void give(const link::BoxStatus& status);
    void give(const link::BoxError& error);
    void noteSilence(const ArrivedBlock& block);
    void flushSilence(size_t board);
    /// Of what a box may send without end; counted in samples.
    class Allowance {
    public:
        bool allow(int64_t sample, int64_t sample_rate_hz);

    private:
        int given_ = 0;
        int64_t last_sample_ = 0;
    };
    void hand(const LiveItem& item);
    void handNote(const std::string& text);

    std::mutex mutex_;  ///< keeps the items of all callers in one order
    std::shared_ptr<Recorder> recorder_;
    std::shared_ptr<LiveProcessor> processor_;
    const Clock clock_;
    std::atomic<int64_t> reached_sample_{0};
    PulseRate pulse_rate_;
    Allowance errors_, statuses_;
    int64_t errors_left_out_ = 0;
    std::vector<std::string> box_warnings_;
    int64_t last_pulse_id_ = 0;
    std::vector<Silence> silences_;  ///< per board, not yet recorded
};

}  // namespace noctule
