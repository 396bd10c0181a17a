// SPDX-License-Identifier: Apache-2.0
// What a board puts on its wire under the sound: its frames as +-A (bit 1 = +A), shaped by a causal 4th-order
// Butterworth low-pass of 9 kHz. ADC counts. core/inertial/README.md section 6.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/inertial/frame_layout.h"

namespace noctule {

/// Fourth-order Butterworth low-pass, bilinear with prewarping: scipy.signal.butter(4, cutoff_hz, fs=...).
class ButterworthLowPass4 {
public:
    /// cutoff below half the sampling rate
    ButterworthLowPass4(double cutoff_hz, double sample_rate_hz);
    double operator()(double x) {
        for (Section& s : sections_) {
            const double y = s.b0 * x + s.z1;
            s.z1 = 2 * s.b0 * x - s.a1 * y + s.z2;
            s.z2 = s.b0 * x - s.a2 * y;
            x = y;
        }
        return x;
    }
    /// Ends a tail that has died away, before it reaches the slow denormal numbers.
    void settle();

private:
    struct Section {
        double b0, a1, a2;  ///< b1 = 2 b0, b2 = b0
        double z1 = 0, z2 = 0;
    };
    std::array<Section, 2> sections_;
};

inline constexpr double kLineCutoff_hz = 9000;

class LineShaper {
public:
    /// Asked once for each frame, in ascending order, when its first sample is due; frame 0 starts at sample
    /// s0, frame -1 before it. Nothing returned: the board is silent for that frame.
    using FrameSource = std::function<std::optional<LineBits>(int64_t frame)>;

    /// Output begins at first_sample, perhaps in the middle of a frame, with the filter at rest.
    LineShaper(int sample_rate_hz, int64_t s0, double amplitude_counts, FrameSource frames,
               int64_t first_sample = 0);

    /// Adds the next samples.size() samples of the line.
    void addTo(std::span<float> samples);

private:
    void beginBit(int64_t bit);

    BitClock clock_;
    double amplitude_counts_;
    FrameSource frames_;
    ButterworthLowPass4 filter_;
    std::optional<LineBits> bits_;  ///< of frame_
    std::optional<int64_t> frame_;
    int64_t sample_;    ///< next to come
    int64_t bit_end_;   ///< first sample of the next bit
    double level_ = 0;  ///< of the present bit
};

}  // namespace noctule
