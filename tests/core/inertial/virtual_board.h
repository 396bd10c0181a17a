// SPDX-License-Identifier: Apache-2.0
// A board for tests: smooth readings, encoded, shaped, with noise and whatever else stands on the wire.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "core/inertial/frame_encoder.h"
#include "core/inertial/line_shaper.h"

namespace noctule {

struct VirtualBoard {
    int sample_rate_hz = 150000;
    int64_t s0 = 137;
    int first_counter = 32;
    bool imu9 = false;
    double amplitude_counts = 300;
    double noise_counts = 30;   ///< white
    double bit_error_rate = 0;  ///< flipped before shaping
    unsigned seed = 1;

    /// What the board's decoder would show, by frame number; frame 0 is the first to start at sample 0 or
    /// later.
    std::map<int64_t, std::array<int, 6>> sent = {};

    /// The board's own number of that frame 0.
    int64_t firstFrame() const {
        return ceilDivide(-s0 * BitClock::kTicksPerSample, int64_t{kBitsPerFrame} * sample_rate_hz);
    }

    std::vector<float> line(int64_t count) {
        std::mt19937 random(seed);
        std::bernoulli_distribution flip(bit_error_rate);
        FrameEncoder encoder(imu9, first_counter);
        LineShaper shaper(sample_rate_hz, s0, amplitude_counts, [&](int64_t frame) {
            LineBits bits = encoder.encode(reading(frame), {2000, 2100, 2200});
            sent[frame - firstFrame()] = encoder.reconstruction();
            for (uint8_t& bit : bits)
                bit ^= static_cast<uint8_t>(flip(random));
            return bits;
        });
        std::vector<float> samples(count, 0.0f);
        shaper.addTo(samples);
        std::normal_distribution<float> noise(0.0f, static_cast<float>(noise_counts));
        for (float& s : samples)
            s += noise(random);
        return samples;
    }

    static std::array<int, 6> reading(int64_t frame) {
        std::array<int, 6> values;
        for (int axis = 0; axis < 6; ++axis)
            values[axis] =
                2048 + static_cast<int>(std::lround(
                           (300 + 200 * axis) * std::sin(0.01 * (axis + 1) * static_cast<double>(frame))));
        return values;
    }
};

inline std::vector<int16_t> sampled(const std::vector<float>& line) {
    std::vector<int16_t> samples(line.size());
    for (size_t i = 0; i < line.size(); ++i)
        samples[i] = static_cast<int16_t>(std::lround(std::clamp(line[i], -32767.0f, 32767.0f)));
    return samples;
}

}  // namespace noctule
