// SPDX-License-Identifier: Apache-2.0
// Turns the samples of one board into readings, as they come: hunts for the stream, locks to it, follows it
// through noise and holes, notices when the board restarts. Blocks may have any size; every split of the same
// samples gives the same readings. Knows only the past, so time before the first lock yields no reading.
// core/inertial/README.md section 7.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/inertial/frame_decoder.h"
#include "core/inertial/phase_search.h"
#include "core/inertial/reading.h"
#include "core/inertial/sample_buffer.h"

namespace noctule {

/// How a board's stream fared so far.
struct StreamReport {
    int64_t frames_seen = 0;     ///< while locked, lost ones included; every one is a reading handed out
    int64_t frames_damaged = 0;  ///< lost: not to be trusted
    int64_t frames_missing = 0;  ///< lost: samples missing
    int64_t bits_corrected = 0;  ///< in trusted frames
    int64_t lock_losses = 0;
    int64_t readings_present = 0;  ///< of six axes
    int64_t readings_clipped = 0;  ///< of those, at 0 or 4095
    double share_present = 0;      ///< of six readings in each frame since the first sample, locked or not
    std::optional<double> amplitude_counts;  ///< A of the line, mean over trusted frames
    std::optional<double> phase_samples;     ///< start of frame 0; absent while hunting

    /// A board with more than 1 % of its frames damaged has a bad signal.
    bool badSignal() const { return 100 * frames_damaged > frames_seen; }
};

class StreamReceiver {
public:
    /// board: put into the readings. A rate outside LineFilter's range is a broken promise.
    StreamReceiver(int board, int sample_rate_hz, bool imu9);

    StreamReceiver(const StreamReceiver&) = delete;
    StreamReceiver& operator=(const StreamReceiver&) = delete;

    static bool supports(int sample_rate_hz) {
        return sample_rate_hz >= LineFilter::kLowestSampleRate_hz &&
               sample_rate_hz <= LineFilter::kHighestSampleRate_hz;
    }
    /// A hole longer than this ends the lock; in a shorter one frames go on being counted as lost.
    static constexpr int64_t kLongestHole_s = 3600;
    static constexpr int64_t kHighestSample = int64_t{1} << 48;

    /// One block of sample-interleaved values; this board's are those of `column`. Samples between the last
    /// block and first_sample are missing; what was pushed before is skipped; a sample number below 0 or
    /// above kHighestSample is ignored.
    void push(int64_t first_sample, std::span<const int16_t> interleaved, int column = 0, int columns = 1);
    /// Samples that count as missing although a block will hold them; call before pushing that block.
    void markMissing(int64_t first_sample, int64_t count);
    /// The recording has ended: what is still held is decoded. A frame cut by the end yields nothing.
    void finish();

    /// Readings since the last call, in order of time.
    std::vector<InertialReading> takeReadings();
    StreamReport report() const;

private:
    /// Frames of the clock are numbered as InertialReading::frame.
    struct Lock {
        BitClock clock;
        int64_t frame;  ///< next to be decoded
        int counter;    ///< the one it should have
        int damaged_in_a_row = 0;
        int restart_error = 0;  ///< of the received counter against ours, 0: none
        int restarts_in_a_row = 0;
    };

    void fillHole(int64_t end);
    void process();
    bool hunt();
    bool decodeFrame();
    void watch(const CheckedFrame& frame, int expected_counter, int64_t frame_end);
    void handOn(const InertialReading& reading);
    void loseLock(int64_t hunt_from);

    int board_, sample_rate_hz_;
    LineFilter filter_;
    PhaseSearch search_;
    FrameDecoder decoder_;
    SampleBuffer samples_;
    int64_t data_first_ = 0, data_end_ = 0;  ///< of the recording so far
    std::optional<Lock> lock_;
    int64_t hunt_from_ = 0;  ///< next trial phase while not locked
    bool finished_ = false;

    std::vector<InertialReading> readings_;
    StreamReport report_;
    double level_sum_ = 0;
};

}  // namespace noctule
