// SPDX-License-Identifier: Apache-2.0
// Sound in, poses out: decoder and tracker of one suit behind one set of push functions, for a recording and
// for a suit that is worn right now. No threads, no clocks. Time advances in hops aligned to the sample
// clock, so the poses are the same for every split of the samples into blocks.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/live/motion_tracker.h"
#include "core/live/suit_decoder.h"

namespace noctule {

struct PipelineSettings {
    DecoderSettings decoder;
    TrackerSettings tracker;
    std::optional<std::pair<int64_t, int64_t>> rest;  ///< first and last sample of the rest pose
    bool tracks = true;  ///< false: readings and ranges only, as of a suit that is not calibrated
};

class LivePipeline {
public:
    static Result<std::unique_ptr<LivePipeline>> create(const Suit& suit, const Calibration& calibration,
                                                        const Actor& actor, const PipelineSettings& settings);

    // All of these before the block that reaches their sample; each kind in order of time.
    void pushPulse(const Pulse& pulse) { pulses_.push_back(pulse); }
    void pushStatus(const TemperatureStatus& status) { statuses_.push_back(status); }
    void pushGap(int64_t first_sample, int64_t count, std::optional<int> board);
    void pushRoot(const RootMeasurement& root);

    void pushBlock(int64_t first_sample, std::span<const int16_t> interleaved);
    /// The recording has ended.
    void finish();

    /// Poses that had to wait for the end, after finish(); as those of Estimator.
    int portionsLeft() const { return tracker_ ? tracker_->portionsLeft() : 0; }
    Status finishPortion(const JobContext& job) {
        return tracker_ ? tracker_->finishPortion(job) : Status(Done{});
    }

    std::vector<TimedPose> takePoses();
    std::vector<RangeMeasurement> takeRanges();
    std::vector<InertialReading> takeReadings() { return std::exchange(readings_, {}); }

    const SuitDecoder& decoder() const { return *decoder_; }
    /// Of a pipeline that tracks.
    const MotionTracker& tracker() const { return *tracker_; }

private:
    LivePipeline(std::unique_ptr<SuitDecoder> decoder, std::unique_ptr<MotionTracker> tracker,
                 int board_count)
        : decoder_(std::move(decoder)), tracker_(std::move(tracker)), board_count_(board_count) {}
    void hop(int64_t first_sample, std::span<const int16_t> interleaved);
    void track(int64_t watermark);

    std::unique_ptr<SuitDecoder> decoder_;
    std::unique_ptr<MotionTracker> tracker_;  ///< null: nothing is tracked
    int board_count_;
    std::deque<Pulse> pulses_;
    std::deque<TemperatureStatus> statuses_;
    std::vector<InertialReading> readings_;
    int64_t samples_end_ = 0;
};

}  // namespace noctule
