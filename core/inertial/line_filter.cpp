// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/line_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/inertial/line_shaper.h"
#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr double kCutoff_hz = 8000, kReach_s = 16 / 150000.0, kKaiserBeta = 6;

double kaiser(double x) {
    return std::cyl_bessel_i(0, kKaiserBeta * std::sqrt(std::max(0.0, 1 - x * x)));
}

double sinc(double x) {
    return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

}  // namespace

double vertexOffset(double early, double middle, double late) {
    const double bend = early - 2 * middle + late;
    return bend < 0 ? std::clamp((early - late) / (2 * bend), -1.0, 1.0) : 0;
}

LineFilter::LineFilter(int sample_rate_hz) {
    require(sample_rate_hz >= kLowestSampleRate_hz && sample_rate_hz <= kHighestSampleRate_hz,
            "LineFilter: sampling rate out of range");
    reach_ = static_cast<int>(std::lround(kReach_s * sample_rate_hz));
    quarter_bit_ = static_cast<int>(std::lround(0.25 * sample_rate_hz / kBitsPerSecond));
    Eigen::VectorXd taps(2 * reach_ + 1);
    for (int i = -reach_; i <= reach_; ++i)
        taps[i + reach_] =
            sinc(2 * kCutoff_hz / sample_rate_hz * i) * kaiser(static_cast<double>(i) / reach_);
    taps_ = (taps / taps.sum()).cast<float>();
    measureShapedBit(sample_rate_hz);
}

// A lone bit of level 1, averaged over all ways in which its edges fall between samples, through the board's
// filter and ours: where it is highest is where the receiver must look, and how high is the gain.
void LineFilter::measureShapedBit(int sample_rate_hz) {
    constexpr int kAlignments = 64;
    const double bit = static_cast<double>(sample_rate_hz) / kBitsPerSecond;
    const int start = 2 * reach_, size = 4 * reach_ + static_cast<int>(8 * bit);
    std::vector<float> line(size, 0.0f);
    for (int a = 0; a < kAlignments; ++a) {
        const double begin = start + (a + 0.5) / kAlignments;
        for (auto s = static_cast<int>(std::ceil(begin)); s < begin + bit; ++s)
            line[s] += 1.0f / kAlignments;
    }
    ButterworthLowPass4 shaper(kLineCutoff_hz, sample_rate_hz);
    for (float& s : line)
        s = static_cast<float>(shaper(s));
    std::vector<double> seen(size, 0.0);
    for (int i = reach_; i < size - reach_; ++i)
        seen[i] = (*this)(&line[i]);
    const auto top = std::max_element(seen.begin(), seen.end());
    const double vertex = vertexOffset(*(top - quarter_bit_), *top, *(top + quarter_bit_));
    const double peak = static_cast<double>(top - seen.begin()) + vertex * quarter_bit_;
    mid_bit_level_ = *top;
    to_middle_ticks_ = std::llround((peak - start - 0.5) * BitClock::kTicksPerSample);
}

}  // namespace noctule
