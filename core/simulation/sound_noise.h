// SPDX-License-Identifier: Apache-2.0
// What every board hears all the time, in two independent parts per board (at 40 kHz a wave is 9 mm long, so
// ambient sound has nothing in common between two boards):
// - ultrasound: white noise through the board's amplifier, (1 - z^-2)^2, a broad band around a quarter of the
//   sample rate (24 to 51 kHz at 150 kHz) with nothing at 0 and at half the sample rate. The scale follows
//   from the integral of |H|^2 = 16 sin^4(2 pi f / fs) over 37.5 to 42.5 kHz. Below 13 kHz it leaves 0.2 of
//   its stated level.
// - low frequencies (handling, muscles, the line): white noise through a two-pole Butterworth low-pass at 8
// kHz,
//   scaled by the integral of its |H|^2 up to 13 kHz. In the ultrasonic band it leaves 0.02 of its level.
// So each level is what the scenario states within 0.5 % in its own band, and neither depends on the other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/simulation/random.h"

namespace noctule::simulation {

class AmbientNoise {
public:
    struct Levels {
        double ultrasound_counts = 0;     ///< rms between 37.5 and 42.5 kHz
        double low_frequency_counts = 0;  ///< rms below 13 kHz
    };
    AmbientNoise(const Levels& levels, double sample_rate_hz, int board_count, uint64_t seed);

    /// Adds the next samples of one board.
    void add(int board, std::vector<float>& samples);

private:
    struct BoardState {
        Random ultrasound, low_frequency;
        std::array<double, 4> white{};    ///< last inputs of the amplifier, newest first
        double delay_1 = 0, delay_2 = 0;  ///< low-pass, transposed direct form II
    };
    void addUltrasound(BoardState& state, std::vector<float>& samples) const;
    void addLowFrequencies(BoardState& state, std::vector<float>& samples) const;

    double white_sigma_ = 0;           ///< of the ultrasound's white noise; 0: none
    double low_pass_sigma_ = 0;        ///< of the low-pass filter's input; 0: none
    double b0_ = 0, a1_ = 0, a2_ = 0;  ///< H = b0 (1 + z^-1)^2 / (1 + a1 z^-1 + a2 z^-2)
    std::vector<BoardState> boards_;
};

}  // namespace noctule::simulation
