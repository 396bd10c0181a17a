// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/phase_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/inertial/frame_decoder.h"

namespace noctule {
namespace {

constexpr int kMostWrongSyncBits = 2;

}  // namespace

PhaseSearch::PhaseSearch(int sample_rate_hz, const LineFilter& filter)
    : sample_rate_hz_(sample_rate_hz), filter_(filter) {
    const double bit = static_cast<double>(sample_rate_hz) / kBitsPerSecond;
    step_ = std::max(1, static_cast<int>(std::lround(bit / 6)));
    bit_samples_ = static_cast<int>(std::ceil(bit));
    frame_samples_ = static_cast<int>(std::ceil(bit * kBitsPerFrame));
    margin_ = 4 * bit_samples_ + filter.reach();
    lookahead_ = kFrames * frame_samples_ + margin_;
    for (int i = 0; i < kSyncBits; ++i)
        to_sync_bit_[i] = static_cast<int>(filter.middleOfBit(BitClock::startingAt(sample_rate_hz, 0), i));
}

std::optional<PhaseSearch::Found> PhaseSearch::search(const SampleBuffer& samples, int64_t first,
                                                      int64_t end) const {
    if (first >= end)
        return std::nullopt;
    const int64_t filtered_first = first + to_sync_bit_.front();
    std::vector<float> filtered(end + to_sync_bit_.back() - filtered_first);
    for (size_t i = 0; i < filtered.size(); ++i)
        filtered[i] = filter_(samples.at(filtered_first + static_cast<int64_t>(i)));

    // The threshold is the mean over the trial frame, kept up as a sliding sum of integers, hence exactly.
    double sum = std::accumulate(samples.at(first), samples.at(first) + frame_samples_, 0.0);
    for (int64_t phase = first; phase < end; phase += step_) {
        const auto threshold = static_cast<float>(sum / frame_samples_);
        const float* at = &filtered[phase - first];
        int wrong = 0;
        for (int i = 0; i < kSyncBits && wrong <= kMostWrongSyncBits; ++i) {
            const bool one = at[to_sync_bit_[i] - to_sync_bit_[0]] > threshold;
            wrong += one != (kSync >> (kSyncBits - 1 - i) & 1);
        }
        if (wrong <= kMostWrongSyncBits)
            if (const auto found = tryPhase(samples, phase))
                return found;
        for (int i = 0; i < step_; ++i)
            sum += *samples.at(phase + frame_samples_ + i) - *samples.at(phase + i);
    }
    return std::nullopt;
}

std::optional<PhaseSearch::Found> PhaseSearch::tryPhase(const SampleBuffer& samples, int64_t phase) const {
    if (!counterOfRun(samples, BitClock::startingAt(sample_rate_hz_, phase)))
        return std::nullopt;
    const BitClock clock = refined(samples, phase);
    if (samples.anyMissing(clock.firstSampleOfFrame(0), clock.firstSampleOfFrame(kFrames)))
        return std::nullopt;
    const auto counter = counterOfRun(samples, clock);
    return counter ? std::optional(Found{clock, *counter}) : std::nullopt;
}

/// Counter of the first of four trusted frames with rising counters; absent when they are not.
std::optional<int> PhaseSearch::counterOfRun(const SampleBuffer& samples, const BitClock& clock) const {
    int first_counter = 0;
    for (int frame = 0, expected = 0; frame < kFrames; ++frame, expected = nextCounter(expected)) {
        const LineBits bits = readFrame(samples, filter_, clock, frame).bits;
        if (frame == 0)
            first_counter = expected = receivedCounter(bits);
        if (expected >= kCounterPeriod || !checkFrame(bits, expected).trusted)
            return std::nullopt;
    }
    return first_counter;
}

PhaseSearch::Run PhaseSearch::readRun(const SampleBuffer& samples, int64_t origin_ticks) const {
    Run run;
    for (int frame = 0; frame < kFrames; ++frame)
        run[frame] = readFrame(samples, filter_, {sample_rate_hz_, origin_ticks}, frame);
    return run;
}

/// How well the line matches the bits when read at that phase; arbitrary unit.
double PhaseSearch::match(const SampleBuffer& samples, const Run& run, int64_t origin_ticks) const {
    const BitClock clock{sample_rate_hz_, origin_ticks};
    double sum = 0;
    for (int frame = 0; frame < kFrames; ++frame)
        for (int i = 0; i < kBitsPerFrame; ++i) {
            const int64_t middle = filter_.middleOfBit(clock, frame * kBitsPerFrame + i);
            const double value = filter_(samples.at(middle)) - run[frame].offset;
            sum += run[frame].bits[i] ? value : -value;
        }
    return sum;
}

/// The first phase at which the frames can be read lies early in the eye. Its bits, now known, are matched to
/// the line at neighbouring phases; the vertex through the best and a quarter of a bit on each side is the
/// phase, to some hundredths of a sample.
BitClock PhaseSearch::refined(const SampleBuffer& samples, int64_t phase) const {
    constexpr int64_t kTicks = BitClock::kTicksPerSample;
    Run run = readRun(samples, phase * kTicks);
    int64_t best = phase * kTicks;
    double best_match = 0;
    for (int64_t trial = phase - bit_samples_ / 2; trial <= phase + bit_samples_; ++trial)
        if (const double at_trial = match(samples, run, trial * kTicks); at_trial > best_match) {
            best_match = at_trial;
            best = trial * kTicks;
        }
    run = readRun(samples, best);  // without the errors of the eye's edge
    const int64_t apart = filter_.quarterBit() * kTicks;
    const double vertex = vertexOffset(match(samples, run, best - apart), match(samples, run, best),
                                       match(samples, run, best + apart));
    return {sample_rate_hz_, best + std::llround(vertex * static_cast<double>(apart))};
}

}  // namespace noctule
