// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/stream_receiver.h"

#include <algorithm>
#include <utility>

#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr int kDamagedFramesToUnlock = 140, kRestartFramesToUnlock = 8;

}  // namespace

StreamReceiver::StreamReceiver(int board, int sample_rate_hz, bool imu9)
    : board_(board),
      sample_rate_hz_(sample_rate_hz),
      filter_(sample_rate_hz),
      search_(sample_rate_hz, filter_),
      decoder_(imu9),
      samples_(search_.margin()) {}

void StreamReceiver::push(int64_t first_sample, std::span<const int16_t> interleaved, int column,
                          int columns) {
    require(columns > 0 && column >= 0 && column < columns && interleaved.size() % columns == 0,
            "StreamReceiver::push: the block does not fit its columns");
    require(!finished_, "StreamReceiver::push after finish");
    if (first_sample < 0 || first_sample > kHighestSample || interleaved.empty())
        return;
    if (!samples_.started()) {
        samples_.startAt(first_sample);
        data_first_ = hunt_from_ = first_sample;
    }
    fillHole(first_sample);
    const auto count = static_cast<int64_t>(interleaved.size()) / columns;
    const int64_t known = std::min(samples_.end() - first_sample, count);
    samples_.append(interleaved.subspan(known * columns), column, columns);
    data_end_ = samples_.end();
    process();
}

void StreamReceiver::markMissing(int64_t first_sample, int64_t count) {
    if (first_sample >= 0 && first_sample <= kHighestSample && count > 0)
        samples_.markMissing(first_sample, first_sample + std::min(count, kHighestSample));
}

void StreamReceiver::fillHole(int64_t end) {
    if (end - samples_.end() > kLongestHole_s * sample_rate_hz_) {
        loseLock(end);
        samples_.startAt(end);
    }
    while (samples_.end() < end) {
        samples_.appendMissing(std::min<int64_t>(end - samples_.end(), sample_rate_hz_ / 10));
        data_end_ = samples_.end();
        process();
    }
}

void StreamReceiver::finish() {
    if (std::exchange(finished_, true) || !samples_.started())
        return;
    samples_.appendMissing(search_.margin());
    process();
}

void StreamReceiver::process() {
    while (lock_ ? decodeFrame() : hunt()) {
    }
    const int64_t next = lock_ ? lock_->clock.firstSampleOfFrame(lock_->frame) : hunt_from_;
    samples_.forgetBefore(next - search_.margin());
}

/// Tries the phases of about a frame at once; false when samples must come first.
bool StreamReceiver::hunt() {
    const int64_t batch = sample_rate_hz_ / kInertialFramesPerSecond;
    int64_t end = samples_.end() - search_.lookahead();
    if (end - hunt_from_ < batch && !finished_)
        return false;
    end = std::min(end, hunt_from_ + batch);
    const auto found = search_.search(samples_, hunt_from_, end);
    if (!found) {
        const int64_t trials = std::max<int64_t>(0, ceilDivide(end - hunt_from_, search_.step()));
        hunt_from_ += trials * search_.step();
        return trials > 0;
    }
    // Half a sample of grace: the first frame of a board that was switched on at sample 0 is frame 0 although
    // its phase is measured as a hair before.
    BitClock clock = found->clock;
    const int64_t frame_ticks = kBitsPerFrame * clock.sample_rate_hz;
    const int64_t frame = floorDivide(clock.origin_ticks + BitClock::kTicksPerSample / 2, frame_ticks);
    clock.origin_ticks -= frame * frame_ticks;
    lock_ = Lock{clock, frame, found->counter};
    return true;
}

/// Decodes the next frame of a locked stream; false when samples must come first.
bool StreamReceiver::decodeFrame() {
    const BitClock clock = lock_->clock;
    const int64_t frame = lock_->frame;
    const int counter = lock_->counter;
    const int64_t first = clock.firstSampleOfFrame(frame), end = clock.firstSampleOfFrame(frame + 1);
    const int64_t last_middle = filter_.middleOfBit(clock, (frame + 1) * kBitsPerFrame - 1);
    if (end > data_end_ || last_middle + filter_.reach() >= samples_.end())
        return false;
    lock_->frame = frame + 1;
    lock_->counter = nextCounter(counter);
    InertialReading reading;
    if (samples_.anyMissing(first, end)) {
        reading = decoder_.lose(counter);
        ++report_.frames_missing;
    } else {
        const ReadFrame read = readFrame(samples_, filter_, clock, frame);
        const CheckedFrame checked = checkFrame(read.bits, counter);
        reading = decoder_.decode(checked, counter);
        level_sum_ += checked.trusted ? read.level : 0;
        report_.frames_damaged += !checked.trusted;
        watch(checked, counter, end);
    }
    reading.board = board_;
    reading.frame = frame;
    reading.sample = clock.frameStart(frame);
    handOn(reading);
    return true;
}

/// Ends the lock when the signal has gone or the board has evidently restarted.
void StreamReceiver::watch(const CheckedFrame& frame, int expected_counter, int64_t frame_end) {
    lock_->damaged_in_a_row = frame.trusted ? 0 : lock_->damaged_in_a_row + 1;
    const bool header_readable = frame.wrong_sync_bits <= 1 && frame.received_counter < kCounterPeriod;
    const int error =
        header_readable ? (frame.received_counter - expected_counter + kCounterPeriod) % kCounterPeriod : 0;
    const bool same = error == lock_->restart_error;
    lock_->restarts_in_a_row = error == 0 ? 0 : same ? lock_->restarts_in_a_row + 1 : 1;
    lock_->restart_error = error;
    if (lock_->damaged_in_a_row >= kDamagedFramesToUnlock ||
        lock_->restarts_in_a_row >= kRestartFramesToUnlock)
        loseLock(frame_end);
}

void StreamReceiver::loseLock(int64_t hunt_from) {
    report_.lock_losses += lock_.has_value();
    lock_.reset();
    decoder_.forget();
    hunt_from_ = hunt_from;
}

void StreamReceiver::handOn(const InertialReading& reading) {
    if (reading.frame < 0)
        return;  // began before the recording, by less than a sample
    ++report_.frames_seen;
    report_.bits_corrected += reading.corrected_bits.value_or(0);
    for (const auto& count : reading.counts) {
        report_.readings_present += count.has_value();
        report_.readings_clipped += count == kCountsMin || count == kCountsMax;
    }
    readings_.push_back(reading);
}

std::vector<InertialReading> StreamReceiver::takeReadings() {
    return std::exchange(readings_, {});
}

StreamReport StreamReceiver::report() const {
    StreamReport report = report_;
    const int64_t frames = (data_end_ - data_first_) * kInertialFramesPerSecond / sample_rate_hz_;
    if (frames > 0)
        report.share_present =
            static_cast<double>(report.readings_present) / (6.0 * static_cast<double>(frames));
    const int64_t trusted = report.frames_seen - report.frames_damaged - report.frames_missing;
    if (trusted > 0)
        report.amplitude_counts = level_sum_ / static_cast<double>(trusted) / filter_.midBitLevel();
    if (lock_)
        report.phase_samples = lock_->clock.frameStart(0);
    return report;
}

}  // namespace noctule
