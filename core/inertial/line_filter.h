// SPDX-License-Identifier: Apache-2.0
// The receiver's low-pass: takes the stream out from under the sound. A linear-phase windowed sinc (cutoff
// 8 kHz, Kaiser window, 0.21 ms long whatever the sampling rate) that is 80 dB down from 37 kHz on. It costs
// nothing unless asked: a locked receiver evaluates it at the 92 middles of a frame's bits only.
//
// Choice: of cutoffs from 3 to 12 kHz and lengths from 0.1 to 0.3 ms this has the best ratio of worst-case
// eye opening (0.78 of the amplitude, with the shaping filter) to noise; longer ones win less than 1 %.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/inertial/bit_clock.h"

namespace noctule {

class LineFilter {
public:
    /// sample_rate_hz: kLowestSampleRate_hz..kHighestSampleRate_hz
    explicit LineFilter(int sample_rate_hz);

    static constexpr int kLowestSampleRate_hz = 90000;  ///< below it the pulses alias onto the stream
    static constexpr int kHighestSampleRate_hz = 2000000;

    /// Taps on each side of the middle one.
    int reach() const { return reach_; }
    /// Output at *middle; reads reach() samples on each side.
    float operator()(const float* middle) const {
        return taps_.dot(Eigen::Map<const Eigen::VectorXf>(middle - reach_, taps_.size()));
    }
    /// Sample at which a bit of the line is read: its middle plus the delay of the board's shaping filter.
    int64_t middleOfBit(const BitClock& clock, int64_t bit) const {
        const int64_t start_ticks = clock.origin_ticks + bit * clock.sample_rate_hz;
        return floorDivide(start_ticks + to_middle_ticks_ + BitClock::kTicksPerSample / 2,
                           BitClock::kTicksPerSample);
    }
    /// Mean level at mid-bit of a line of amplitude 1, shaped and filtered.
    double midBitLevel() const { return mid_bit_level_; }
    /// Distance, in samples, of the early and late looks that phase refinement compares: a quarter of a bit.
    int quarterBit() const { return quarter_bit_; }

private:
    void measureShapedBit(int sample_rate_hz);

    int reach_;
    int quarter_bit_;
    Eigen::VectorXf taps_;
    int64_t to_middle_ticks_ = 0;
    double mid_bit_level_ = 0;
};

/// Where a parabola through three equidistant values has its vertex, in units of their distance from the
/// middle one; within -1..1, and 0 where they do not bend downwards.
double vertexOffset(double early, double middle, double late);

}  // namespace noctule
