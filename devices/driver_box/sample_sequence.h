// SPDX-License-Identifier: Apache-2.0
// Puts ADC blocks in their place on the sample clock (README.md, section 6): compares each block's first
// sample with the expected one, so that lost sound becomes a gap and time never shifts. Overlapping blocks
// are cut to their new part, wholly old ones dropped, impossible ones count as damaged. One object lives from
// START to the end of the take, over reconnections. Samples count from 0.
#pragma once

#include <optional>

#include "devices/driver_box/messages.h"

namespace noctule::link {

/// Who lost it. Takes know `board` and `studio` as well, which are not the link's to tell.
enum class GapReason { kLink, kBox };

struct Gap {
    int64_t first_sample = 0;
    int64_t sample_count = 0;
    GapReason reason = GapReason::kLink;
    bool operator==(const Gap&) const = default;
};

class SampleSequence {
public:
    /// Farther ahead of the last sample is damage.
    static constexpr int64_t kFarthest_s = 60, kFarthestAfterReconnection_s = 150;

    /// `board_count` as HELLO has it.
    SampleSequence(int board_count, int sample_rate_hz);

    enum class Verdict {
        kNew,      ///< use it, after the gap if there is one
        kOld,      ///< all of it was there already
        kDamaged,  ///< not of this suit, or from an impossible time
    };
    struct Placement {
        Verdict verdict = Verdict::kNew;
        std::optional<Gap> gap;
    };
    /// Cuts a kNew block to its new part. `link_lost_frames`: frames were lost or damaged since the last kNew
    /// block; then a gap is the link's, otherwise the box's.
    Placement place(SoundBlock& block, bool link_lost_frames);

    /// Of pulses and status: no farther ahead than a block may be.
    bool isPlausible(int64_t sample) const { return sample <= next_sample_ - 1 + farthest_; }

    /// The next block may be farther ahead, and the gap before it is the link's.
    void expectReconnection();
    /// The box says that it dropped sound from this sample on: that gap is the box's.
    void noteOverrun(int64_t first_dropped_sample) { overrun_sample_ = first_dropped_sample; }

    int64_t nextSample() const { return next_sample_; }
    int64_t lostSamples() const { return lost_samples_; }

private:
    GapReason reasonOf(int64_t first_sample, int64_t end, bool link_lost_frames) const;

    int board_count_;
    int64_t farthest_, farthest_after_reconnection_, farthest_usually_;  ///< in samples
    int64_t next_sample_ = 0;
    int64_t lost_samples_ = 0;
    bool reconnecting_ = false;
    std::optional<int64_t> overrun_sample_;
};

}  // namespace noctule::link
