// SPDX-License-Identifier: Apache-2.0
// The receiver's side of one aligned frame: is it to be trusted, and which readings does it yield? The Golay
// code alone would "correct" half of all noise into false readings, hence the trust rule.
// core/inertial/README.md sections 3, 4 and 7.
#pragma once

#include <array>
#include <optional>

#include "core/inertial/frame_layout.h"
#include "core/inertial/reading.h"

namespace noctule {

/// At most so many of a frame's 92 bits may be wrong: sync, counter and payload together.
inline constexpr int kMostWrongBits = 5;

/// A frame held against the counter it should have.
struct CheckedFrame {
    bool trusted = false;
    int wrong_bits = 0;  ///< of all 92; only when trusted
    int wrong_sync_bits = 0;
    int received_counter = 0;         ///< 0..127
    std::array<uint32_t, 3> words{};  ///< 12 data bits each; only when trusted
};
CheckedFrame checkFrame(const LineBits& bits, int expected_counter);

/// Follows the six axes of a board through trusted and lost frames. An axis is unknown from the start or a
/// lost frame that carries it until its next trusted refresh, and yields no reading then.
class FrameDecoder {
public:
    explicit FrameDecoder(bool imu9 = false) : imu9_(imu9) {}

    /// Readings of the next frame; counts and corrected_bits are absent when it is not trusted.
    InertialReading decode(const LineBits& bits, int expected_counter) {
        return decode(checkFrame(bits, expected_counter), expected_counter);
    }
    InertialReading decode(const CheckedFrame& frame, int counter);

    /// The next frame never arrived whole.
    InertialReading lose(int counter);
    /// Every axis becomes unknown.
    void forget() { reconstruction_ = {}; }

private:
    void takeWord(const WordContent& content, int data, InertialReading& reading);
    void takeCode(int axis, int code, InertialReading& reading);

    bool imu9_;
    std::array<std::optional<int>, 6> reconstruction_;  ///< absent: the axis is unknown
};

}  // namespace noctule
