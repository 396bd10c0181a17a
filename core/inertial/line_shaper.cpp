// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/line_shaper.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/job/contract.h"

namespace noctule {

ButterworthLowPass4::ButterworthLowPass4(double cutoff_hz, double sample_rate_hz) {
    require(cutoff_hz > 0 && 2 * cutoff_hz < sample_rate_hz, "ButterworthLowPass4: cutoff out of range");
    const double k = std::tan(std::numbers::pi * cutoff_hz / sample_rate_hz);
    for (size_t i = 0; i < sections_.size(); ++i) {
        const double inverse_q = 2 * std::cos((2 * static_cast<double>(i) + 1) * std::numbers::pi / 8);
        const double norm = 1 + k * inverse_q + k * k;
        sections_[i] = {k * k / norm, 2 * (k * k - 1) / norm, (1 - k * inverse_q + k * k) / norm};
    }
}

void ButterworthLowPass4::settle() {
    constexpr double kNothing = 1e-12;
    const auto quiet = [](const Section& s) { return std::abs(s.z1) + std::abs(s.z2) < kNothing; };
    if (std::all_of(sections_.begin(), sections_.end(), quiet))
        for (Section& s : sections_)
            s.z1 = s.z2 = 0;
}

LineShaper::LineShaper(int sample_rate_hz, int64_t s0, double amplitude_counts, FrameSource frames,
                       int64_t first_sample)
    : clock_(BitClock::startingAt(sample_rate_hz, s0)),
      amplitude_counts_(amplitude_counts),
      frames_(std::move(frames)),
      filter_(kLineCutoff_hz, sample_rate_hz),
      sample_(first_sample),
      bit_end_(first_sample) {}

void LineShaper::beginBit(int64_t bit) {
    const int64_t frame = floorDivide(bit, kBitsPerFrame);
    if (frame != frame_) {
        frame_ = frame;
        bits_ = frames_(frame);
        filter_.settle();
    }
    const bool one = bits_ && (*bits_)[bit - frame * kBitsPerFrame];
    level_ = !bits_ ? 0 : one ? amplitude_counts_ : -amplitude_counts_;
    bit_end_ = clock_.firstSampleOfBit(bit + 1);
}

void LineShaper::addTo(std::span<float> samples) {
    for (size_t i = 0; i < samples.size();) {
        if (sample_ == bit_end_)
            beginBit(clock_.bitOfSample(sample_));
        const auto run = std::min<int64_t>(samples.size() - i, bit_end_ - sample_);
        ButterworthLowPass4 filter = filter_;  // in registers while the run lasts
        for (int64_t k = 0; k < run; ++k)
            samples[i + k] += static_cast<float>(filter(level_));
        filter_ = filter;
        i += run;
        sample_ += run;
    }
}

}  // namespace noctule
