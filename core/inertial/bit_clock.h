// SPDX-License-Identifier: Apache-2.0
// Which sample belongs to which bit of a board's stream, in exact integers for any sampling rate: nothing is
// ever accumulated. Time is counted in ticks of 1/12880 sample, in which a bit lasts exactly sample_rate_hz
// ticks and every bit and frame boundary is an integer. core/inertial/README.md section 1.
#pragma once

#include <cstdint>

namespace noctule {

inline constexpr int kBitsPerFrame = 92;
inline constexpr int kBitsPerSecond = 12880;

constexpr int64_t floorDivide(int64_t a, int64_t b) {
    return a / b - (a % b < 0);
}
constexpr int64_t ceilDivide(int64_t a, int64_t b) {
    return -floorDivide(-a, b);
}

struct BitClock {
    int64_t sample_rate_hz = 150000;
    int64_t origin_ticks = 0;  ///< start of bit 0 of frame 0; a board's phase s0 is origin_ticks / 12880

    static constexpr int64_t kTicksPerSample = kBitsPerSecond;

    static constexpr BitClock startingAt(int64_t sample_rate_hz, int64_t s0) {
        return {sample_rate_hz, s0 * kTicksPerSample};
    }
    constexpr int64_t bitOfSample(int64_t sample) const {
        return floorDivide(sample * kTicksPerSample - origin_ticks, sample_rate_hz);
    }
    constexpr int64_t firstSampleOfBit(int64_t bit) const {
        return ceilDivide(origin_ticks + bit * sample_rate_hz, kTicksPerSample);
    }
    constexpr int64_t firstSampleOfFrame(int64_t frame) const {
        return firstSampleOfBit(frame * kBitsPerFrame);
    }
    /// Instant at which a frame starts, and of the readings it carries; samples.
    constexpr double frameStart(int64_t frame) const {
        return static_cast<double>(origin_ticks + frame * kBitsPerFrame * sample_rate_hz) / kTicksPerSample;
    }
};

}  // namespace noctule
