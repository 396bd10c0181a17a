// SPDX-License-Identifier: Apache-2.0
#include "core/live/live_pipeline.h"

#include <algorithm>

namespace noctule {
namespace {

constexpr int64_t kHop_samples = 300;  // 2 ms at 150 kHz: the finest grain in which time advances

}  // namespace

Result<std::unique_ptr<LivePipeline>> LivePipeline::create(const Suit& suit, const Calibration& calibration,
                                                           const Actor& actor,
                                                           const PipelineSettings& settings) {
    auto decoder = SuitDecoder::create(suit, calibration, settings.decoder);
    if (!decoder)
        return decoder.error();
    auto tracker = MotionTracker::create(suit, calibration, actor, settings.decoder.train.sample_rate_hz,
                                         settings.rest, settings.tracker);
    if (!tracker)
        return tracker.error();
    if (!settings.tracks)
        tracker->reset();  // made all the same: what does not fit is told
    return std::unique_ptr<LivePipeline>(
        new LivePipeline(std::move(*decoder), std::move(*tracker), static_cast<int>(suit.boards.size())));
}

void LivePipeline::pushGap(int64_t first_sample, int64_t count, std::optional<int> board) {
    decoder_->markMissing(first_sample, count, board);
}

void LivePipeline::pushBlock(int64_t first_sample, std::span<const int16_t> interleaved) {
    const int64_t end = first_sample + static_cast<int64_t>(interleaved.size()) / board_count_;
    for (int64_t at = first_sample; at < end;) {
        const int64_t next = std::min(end, (at / kHop_samples + 1) * kHop_samples);
        hop(at, interleaved.subspan(static_cast<size_t>((at - first_sample) * board_count_),
                                    static_cast<size_t>((next - at) * board_count_)));
        at = next;
    }
}

void LivePipeline::hop(int64_t first_sample, std::span<const int16_t> interleaved) {
    samples_end_ = first_sample + static_cast<int64_t>(interleaved.size()) / board_count_;
    // A pulse counts from the hop of its sample on, a temperature from the first hop that begins at its
    // sample or later, however early they were known: a recording must not know more than the live run did,
    // which may learn of a temperature in the middle of a hop.
    const int64_t hop_begin = first_sample / kHop_samples * kHop_samples;
    const int64_t hop_end = hop_begin + kHop_samples;
    for (; !pulses_.empty() && pulses_.front().sample < hop_end; pulses_.pop_front())
        decoder_->pushPulse(pulses_.front());
    for (; !statuses_.empty() && statuses_.front().sample <= hop_begin; statuses_.pop_front())
        decoder_->pushStatus(statuses_.front());
    decoder_->pushBlock(first_sample, interleaved);
    if (samples_end_ % kHop_samples == 0)
        track(decoder_->watermark());
}

void LivePipeline::pushRoot(const RootMeasurement& root) {
    if (tracker_)
        tracker_->add(root);
}

std::vector<TimedPose> LivePipeline::takePoses() {
    return tracker_ ? tracker_->takePoses() : std::vector<TimedPose>();
}

std::vector<RangeMeasurement> LivePipeline::takeRanges() {
    return tracker_ ? tracker_->takeRanges() : decoder_->takeRanges();
}

void LivePipeline::track(int64_t watermark) {
    for (InertialReading& reading : decoder_->takeReadings()) {
        if (tracker_)
            tracker_->add(reading);
        readings_.push_back(std::move(reading));
    }
    if (!tracker_)
        return;
    for (const RangeMeasurement& range : decoder_->takeRanges())
        tracker_->add(range);
    tracker_->advanceTo(watermark);
}

void LivePipeline::finish() {
    decoder_->finish();
    if (tracker_)
        tracker_->end();
    track(samples_end_);
}

}  // namespace noctule
