// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/burst_finder.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr double kAround_s = 0.64e-3;
constexpr double kBefore_s = 0.25e-3, kAfter_s = 0.4e-3;
constexpr double kLeastShareOfPower = 0.01, kLeastOverNoise = 20;
constexpr double kStatedBand_hz = 5000, kRoundingPower_counts2 = 1.0 / 12;
constexpr int16_t kFullScale_counts = 32767;

}  // namespace

BurstFinder::BurstFinder(const PulseTrain& train)
    : sample_rate_hz_(train.sample_rate_hz),
      filter_(train),
      margin_(static_cast<int>(std::ceil(kAround_s * train.sample_rate_hz))),
      window_(2 * margin_ + train.interval_samples),
      burst_(std::max<size_t>(1, static_cast<size_t>(std::lround(train.cycles / train.drive_hz *
                                                                 train.sample_rate_hz / filter_.factor())))),
      first_instant_(filter_.delay() - margin_),
      baseband_(static_cast<size_t>(filter_.outputs(window_))),
      power_(baseband_.size() - burst_ + 1) {}

/// Board after board, a little of each at a time so that what is read stays near.
void BurstFinder::load(std::span<const int16_t> window, size_t boards) {
    constexpr size_t kTile = 32;
    require(window.size() == boards * static_cast<size_t>(window_),
            "a window of another size than the detector's");
    const auto samples = static_cast<size_t>(window_);
    planes_.resize(window.size());
    for (size_t tile = 0; tile < samples; tile += kTile)
        for (size_t board = 0; board < boards; ++board)
            for (size_t i = tile; i < std::min(tile + kTile, samples); ++i)
                planes_[board * samples + i] = window[i * boards + board];
}

void BurstFinder::hear(size_t board) {
    const auto samples = static_cast<size_t>(window_);
    const std::span<const int16_t> sound = std::span(planes_).subspan(board * samples, samples);
    int16_t highest = 0, lowest = 0;
    for (const int16_t sample : sound) {
        highest = std::max(highest, sample);
        lowest = std::min(lowest, sample);
    }
    clipped_ = highest >= kFullScale_counts || lowest <= -kFullScale_counts;
    filter_.run(sound, margin_, baseband_);
    sumBursts();
}

size_t BurstFinder::outputAt(double at) const {
    const double output = std::floor((at - first_instant_) / filter_.factor());
    return static_cast<size_t>(std::clamp(output, 0.0, static_cast<double>(baseband_.size())));
}

Baseband BurstFinder::around(double onset, double noise_power) const {
    const double rate_hz = sample_rate_hz_;
    const size_t begin = outputAt(onset - kBefore_s * rate_hz), end = outputAt(onset + kAfter_s * rate_hz);
    return {std::span(baseband_).subspan(begin, end - begin), instant(static_cast<double>(begin)),
            static_cast<double>(filter_.factor()), noise_power};
}

void BurstFinder::sumBursts() {
    float re = 0, im = 0;
    for (size_t m = 0; m < burst_; ++m) {
        re += baseband_[m].real();
        im += baseband_[m].imag();
    }
    power_[0] = re * re + im * im;
    for (size_t begin = 1; begin < power_.size(); ++begin) {
        const std::complex<float>&in = baseband_[begin + burst_ - 1], &out = baseband_[begin - 1];
        re += in.real() - out.real();  // one addition waits for the last, not two
        im += in.imag() - out.imag();
        power_[begin] = re * re + im * im;
    }
}

/// As InflectionDetector::noisePower(): the lower quartile of exponentially distributed powers.
double BurstFinder::noisePower() {
    quiet_.clear();
    for (size_t m = 0; m < power_.size(); m += burst_)
        quiet_.push_back(power_[m]);
    const auto quartile = quiet_.begin() + std::ssize(quiet_) / 4;
    std::nth_element(quiet_.begin(), quartile, quiet_.end());
    const double power = *quartile / std::log(4.0 / 3.0) / static_cast<double>(burst_);
    return std::max(power, kRoundingPower_counts2 / inBand(1));
}

double BurstFinder::inBand(double noise_power) const {
    return noise_power * kStatedBand_hz / filter_.noiseBandwidth_hz() / 2;
}

BurstFinder::Rise BurstFinder::riseBefore(size_t peak) const {
    const double level = power_[peak] / 4;
    size_t m = peak;
    while (m > 0 && power_[m] > level)
        --m;
    const double below = power_[m], above = power_[std::min(m + 1, power_.size() - 1)];
    const double part = above > below ? (level - below) / (above - below) : 0;
    return {instant(static_cast<double>(m) + part), power_[peak]};
}

std::optional<BurstFinder::Rise> BurstFinder::firstRise(double noise_power) const {
    const size_t begin = std::max(outputAt(0), burst_) - burst_, last = power_.size() - 1;
    const float highest =
        *std::max_element(power_.begin() + static_cast<std::ptrdiff_t>(begin), power_.end());
    const double least =
        std::max(kLeastShareOfPower * highest, kLeastOverNoise * noise_power * static_cast<double>(burst_));
    size_t m = begin;
    while (m < last && power_[m] < least)
        ++m;
    while (m < last && power_[m + 1] > power_[m])
        ++m;
    if (power_[m] < least)
        return std::nullopt;
    return riseBefore(m);
}

double BurstFinder::riseOf(const PulseTemplate& pulse) {
    pulse.sample(first_instant_, filter_.factor(), static_cast<int>(baseband_.size()),
                 [&](int m, float re, float im, float, float) {
                     baseband_[static_cast<size_t>(m)] = {re, im};
                 });
    sumBursts();
    return riseBefore(static_cast<size_t>(std::max_element(power_.begin(), power_.end()) - power_.begin()))
        .instant;
}

}  // namespace noctule
