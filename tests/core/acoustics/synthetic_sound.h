// SPDX-License-Identifier: Apache-2.0
// Sound for the tests of this room: pulses of the pulse model and white noise, sample-interleaved.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/acoustics/pulse_model.h"

namespace noctule {

class SyntheticSound {
public:
    SyntheticSound(const PulseTrain& train, int boards, int64_t samples, uint64_t seed)
        : train_(train), boards_(boards), values_(size_t(boards * samples)), random_(seed) {}

    /// White noise with this rms between 37.5 and 42.5 kHz; of one board or of all (-1).
    void addNoise(double band_rms_counts, int board = -1) {
        const double sigma = band_rms_counts * std::sqrt(train_.sample_rate_hz / 2 / 5000);
        std::normal_distribution<double> normal(0, sigma);
        for (size_t i = 0; i < values_.size(); ++i)
            if (board < 0 || int(i % size_t(boards_)) == board)
                values_[i] += normal(random_);
    }

    /// A pulse whose first motion reaches the board at this fractional sample; `stretch`: of source and board
    /// that approach each other, their speed over that of sound.
    void addPulse(int board, double sample, double amplitude, double resonance_hz = 40000, double q = 25,
                  double stretch = 0) {
        const PulseModel pulse(train_, resonance_hz, q);
        const int64_t count = int64_t(values_.size()) / boards_;
        const int64_t end = std::min(count, int64_t(sample + 0.006 * train_.sample_rate_hz));
        for (int64_t i = std::max<int64_t>(0, int64_t(sample)); i < end; ++i)
            values_[size_t(i * boards_ + board)] +=
                amplitude * pulse.at((double(i) - sample) * (1 + stretch) / train_.sample_rate_hz);
    }

    std::vector<int16_t> counts() const {
        std::vector<int16_t> counts;
        for (const double value : values_)
            counts.push_back(int16_t(std::lround(std::clamp(value, -32767.0, 32767.0))));
        return counts;
    }

    std::mt19937_64& random() { return random_; }

private:
    PulseTrain train_;
    int boards_;
    std::vector<double> values_;
    std::mt19937_64 random_;
};

}  // namespace noctule
