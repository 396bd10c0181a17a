// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/sample_sequence.h"

#include "core/job/contract.h"

namespace noctule::link {

SampleSequence::SampleSequence(int board_count, int sample_rate_hz)
    : board_count_(board_count),
      farthest_(kFarthest_s * sample_rate_hz),
      farthest_after_reconnection_(kFarthestAfterReconnection_s * sample_rate_hz),
      farthest_usually_(farthest_) {
    require(board_count > 0 && sample_rate_hz > 0, "SampleSequence: no boards or no clock");
}

void SampleSequence::expectReconnection() {
    farthest_ = farthest_after_reconnection_;
    reconnecting_ = true;
}

SampleSequence::Placement SampleSequence::place(SoundBlock& block, bool link_lost_frames) {
    if (block.board_count != board_count_ || !isPlausible(block.first_sample))
        return {Verdict::kDamaged, std::nullopt};
    const int64_t end = block.first_sample + block.sampleCount();
    if (end <= next_sample_)
        return {Verdict::kOld, std::nullopt};
    Placement placement;
    const int64_t ahead = block.first_sample - next_sample_;
    if (ahead > 0) {
        placement.gap =
            Gap{next_sample_, ahead, reasonOf(next_sample_, block.first_sample, link_lost_frames)};
        lost_samples_ += ahead;
    } else if (ahead < 0) {
        block.values.erase(block.values.begin(), block.values.begin() - ahead * board_count_);
        block.first_sample = next_sample_;
    }
    next_sample_ = end;
    farthest_ = farthest_usually_;
    reconnecting_ = false;
    if (overrun_sample_ && *overrun_sample_ < end)
        overrun_sample_.reset();
    return placement;
}

GapReason SampleSequence::reasonOf(int64_t first_sample, int64_t end, bool link_lost_frames) const {
    if (reconnecting_)
        return GapReason::kLink;
    const bool announced = overrun_sample_ && *overrun_sample_ >= first_sample && *overrun_sample_ < end;
    return announced || !link_lost_frames ? GapReason::kBox : GapReason::kLink;
}

}  // namespace noctule::link
