// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_noise.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace noctule::simulation {
namespace {

using std::numbers::pi;
constexpr double kBandLow_hz = 37500, kBandHigh_hz = 42500;
constexpr double kLowFrequencies_hz = 13000, kLowPass_hz = 8000;

/// Variance that white noise of variance 1 keeps between two frequencies behind a filter of that |H|^2.
template <class PowerGain>
double bandPower(double low_hz, double high_hz, double sample_rate_hz, PowerGain powerGain) {
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        sum += powerGain(2 * pi * (low_hz + (high_hz - low_hz) * (i + 0.5) / kSteps) / sample_rate_hz);
    return sum / kSteps * (high_hz - low_hz) / (0.5 * sample_rate_hz);
}

}  // namespace

AmbientNoise::AmbientNoise(const Levels& levels, double sample_rate_hz, int board_count, uint64_t seed) {
    white_sigma_ = levels.ultrasound_counts /
                   std::sqrt(bandPower(kBandLow_hz, kBandHigh_hz, sample_rate_hz,
                                       [](double angle) { return 16 * std::pow(std::sin(angle), 4); }));
    // Butterworth through the bilinear transform.
    const double warped = std::tan(pi * kLowPass_hz / sample_rate_hz);
    const double scale = 1 / (1 + std::numbers::sqrt2 * warped + warped * warped);
    b0_ = warped * warped * scale;
    a1_ = 2 * (warped * warped - 1) * scale;
    a2_ = (1 - std::numbers::sqrt2 * warped + warped * warped) * scale;
    const auto lowPass = [this](double angle) {
        const std::complex<double> z1 = std::polar(1.0, -angle);
        return std::norm(b0_ * (1.0 + z1) * (1.0 + z1) / (1.0 + a1_ * z1 + a2_ * z1 * z1));
    };
    low_pass_sigma_ =
        levels.low_frequency_counts / std::sqrt(bandPower(0, kLowFrequencies_hz, sample_rate_hz, lowPass));
    for (uint64_t b = 0; b < static_cast<uint64_t>(board_count); ++b)
        boards_.push_back({Random(seed, "ultrasonic noise", b), Random(seed, "low frequency noise", b)});
}

void AmbientNoise::add(int board, std::vector<float>& samples) {
    BoardState& state = boards_[static_cast<size_t>(board)];
    if (white_sigma_ > 0)
        addUltrasound(state, samples);
    if (low_pass_sigma_ > 0)
        addLowFrequencies(state, samples);
}

void AmbientNoise::addUltrasound(BoardState& state, std::vector<float>& samples) const {
    Random random = state.ultrasound;
    auto [w1, w2, w3, w4] = state.white;
    for (float& sample : samples) {
        const double w0 = white_sigma_ * random.gaussian();
        sample += static_cast<float>(w0 - 2 * w2 + w4);
        w4 = w3;
        w3 = w2;
        w2 = w1;
        w1 = w0;
    }
    state.white = {w1, w2, w3, w4};
    state.ultrasound = random;
}

void AmbientNoise::addLowFrequencies(BoardState& state, std::vector<float>& samples) const {
    Random random = state.low_frequency;
    double delay_1 = state.delay_1, delay_2 = state.delay_2;
    const double scale = b0_ * low_pass_sigma_ * std::sqrt(6.0) * 0x1p-32;
    for (float& sample : samples) {
        // The sum of two uniform halves will do: the filter, averaging over ten samples, makes it normal.
        const uint64_t word = random.bits();
        const auto sum = static_cast<int64_t>((word >> 32) + (word & 0xFFFFFFFF)) - 0xFFFFFFFF;
        const double in = scale * static_cast<double>(sum);
        const double out = in + delay_1;
        delay_1 = 2 * in - a1_ * out + delay_2;
        delay_2 = in - a2_ * out;
        sample += static_cast<float>(out);
    }
    state.delay_1 = delay_1;
    state.delay_2 = delay_2;
    state.low_frequency = random;
}

}  // namespace noctule::simulation
