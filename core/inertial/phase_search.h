// SPDX-License-Identifier: Apache-2.0
// Finds a board's stream in samples of unknown phase: the first four consecutive trusted frames with rising
// counters, then their phase to a fraction of a sample. core/inertial/README.md section 7, "Hunting".
#pragma once

#include <optional>

#include "core/inertial/line_reader.h"

namespace noctule {

class PhaseSearch {
public:
    static constexpr int kFrames = 4;

    PhaseSearch(int sample_rate_hz, const LineFilter& filter);

    /// Samples that must follow a trial phase, at least, before it can be judged.
    int64_t lookahead() const { return lookahead_; }
    /// Samples beyond the ends of the data that are read (as zeros).
    int margin() const { return margin_; }
    /// Distance of trial phases: about a sixth of a bit.
    int step() const { return step_; }

    struct Found {
        BitClock clock;  ///< its frame 0 is the first of the four
        int counter;     ///< of that frame
    };
    /// Tries the phases first, first + step(), ... below end.
    std::optional<Found> search(const SampleBuffer& samples, int64_t first, int64_t end) const;

private:
    using Run = std::array<ReadFrame, kFrames>;

    std::optional<Found> tryPhase(const SampleBuffer& samples, int64_t phase) const;
    std::optional<int> counterOfRun(const SampleBuffer& samples, const BitClock& clock) const;
    BitClock refined(const SampleBuffer& samples, int64_t phase) const;
    Run readRun(const SampleBuffer& samples, int64_t origin_ticks) const;
    double match(const SampleBuffer& samples, const Run& run, int64_t origin_ticks) const;

    int sample_rate_hz_;
    const LineFilter& filter_;
    int step_, bit_samples_, frame_samples_, margin_;
    int64_t lookahead_;
    std::array<int, kSyncBits> to_sync_bit_;  ///< from a frame's first sample to where each bit is read
};

}  // namespace noctule
