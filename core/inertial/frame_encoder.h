// SPDX-License-Identifier: Apache-2.0
// The board's side of the stream: readings in, line bits of one frame out. Delta modulation against the
// encoder's own reconstruction; what one frame rounds away the next pays back (paper section 4.2).
// core/inertial/README.md sections 2 and 3.
#pragma once

#include <array>

#include "core/inertial/frame_layout.h"

namespace noctule {

class FrameEncoder {
public:
    /// A board just powered up, or one whose counter happens to stand at first_counter (0..119).
    explicit FrameEncoder(bool imu9 = false, int first_counter = 0);

    /// The next frame. Readings outside 0..4095 saturate; the magnetometer's are sent seven times a second.
    LineBits encode(const std::array<int, 6>& reading, const std::array<int, 3>& magnetometer = {});

    /// Counter of the frame that encode() makes next.
    int counter() const { return counter_; }
    const std::array<int, 6>& reconstruction() const { return reconstruction_; }
    /// Per axis the running sum of (sent reconstruction - reading), -200..200.
    const std::array<int, 6>& roundingSum() const { return rounding_sum_; }

private:
    uint32_t codeFor(int axis, int reading);

    bool imu9_;
    int counter_;
    std::array<int, 6> reconstruction_{2048, 2048, 2048, 2048, 2048, 2048};
    std::array<int, 6> rounding_sum_{};
};

}  // namespace noctule
