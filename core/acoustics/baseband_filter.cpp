// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/baseband_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr double kOutputRate_hz = 25e3, kPass_hz = 3500;
constexpr double kStop_db = 60, kKaiserBeta = 5.65;  // Kaiser's formulae for 60 dB
constexpr int kLanes = 8;                            // taps come in whole vectors of int16
constexpr int kUsualTaps = 32;                       // at 150 kHz

double kaiserWindow(double x) {
    return std::cyl_bessel_i(0.0, kKaiserBeta * std::sqrt(std::max(0.0, 1 - x * x)));
}

/// As many taps as fall from the pass band to where folding begins.
int tapsFor(double rate_hz, int factor) {
    const double transition = (rate_hz / factor - 2 * kPass_hz) / rate_hz;
    const double taps = (kStop_db - 8) / (2.285 * 2 * std::numbers::pi * transition);
    return kLanes * static_cast<int>(std::ceil(taps / kLanes));
}

/// Sums of products with two sets of weights; kCount known beforehand spares the loop.
template <int kCount>
std::array<int32_t, 2> dots(const int16_t* x, const int16_t* a, const int16_t* b, int count = kCount) {
    int32_t first = 0, second = 0;
    const int known = kCount > 0 ? kCount : count;
    for (int i = 0; i < known; ++i) {
        first += static_cast<int32_t>(x[i]) * a[i];
        second += static_cast<int32_t>(x[i]) * b[i];
    }
    return {first, second};
}

}  // namespace

BasebandFilter::BasebandFilter(const PulseTrain& train)
    : rad_per_sample_(2 * std::numbers::pi * train.drive_hz / train.sample_rate_hz),
      factor_(std::max(1, static_cast<int>(std::lround(train.sample_rate_hz / kOutputRate_hz)))),
      taps_(tapsFor(train.sample_rate_hz, factor_)) {
    const double middle = delay(), cutoff = 1.0 / (2 * factor_);
    double sum = 0, largest = 0;
    for (int k = 0; k < taps_; ++k) {
        const double x = k - middle, angle = 2 * std::numbers::pi * cutoff * x;  // x is never 0
        weights_.push_back(std::sin(angle) / angle * kaiserWindow(x / (middle + 0.5)));
        sum += weights_.back();
    }
    for (double& weight : weights_) {
        weight /= sum;
        noise_bandwidth_hz_ += weight * weight * train.sample_rate_hz;
        largest += std::abs(weight);
    }
    // Full scale times the sum of all weights stays below 2^31; factor 2: a sine is two exponentials.
    const double unit = 60000 / largest;
    scale_ = 2 / unit;
    for (int k = 0; k < taps_; ++k) {
        const std::complex<double> mixed = std::polar(unit * weights_[k], -rad_per_sample_ * (k - middle));
        real_.push_back(static_cast<int16_t>(std::lround(mixed.real())));
        imaginary_.push_back(static_cast<int16_t>(std::lround(mixed.imag())));
    }
}

void BasebandFilter::run(std::span<const int16_t> samples, double origin,
                         std::span<std::complex<float>> out) const {
    require(outputs(static_cast<int>(samples.size())) >= static_cast<int>(out.size()),
            "too few samples for the baseband");
    // sin = (e^ip - e^-ip) / 2i: times i turns the phase of a sine into that of the exponential.
    std::complex<double> turn = std::polar(scale_, rad_per_sample_ * (origin - delay()));
    turn *= std::complex<double>(0, 1);
    const std::complex<double> step = std::polar(1.0, -rad_per_sample_ * factor_);
    const int16_t* from = samples.data();
    for (std::complex<float>& value : out) {
        const auto [re, im] = taps_ == kUsualTaps ? dots<kUsualTaps>(from, real_.data(), imaginary_.data())
                                                  : dots<0>(from, real_.data(), imaginary_.data(), taps_);
        value = {static_cast<float>(re * turn.real() - im * turn.imag()),
                 static_cast<float>(re * turn.imag() + im * turn.real())};
        turn = {turn.real() * step.real() - turn.imag() * step.imag(),
                turn.real() * step.imag() + turn.imag() * step.real()};
        from += factor_;
    }
}

}  // namespace noctule
