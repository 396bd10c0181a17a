// SPDX-License-Identifier: Apache-2.0
// One frame of a board's digital stream as decoded: raw counts 0..4095, absent where the format yields none.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace noctule {

struct InertialReading {
    int board = 0;
    int64_t frame = 0;  ///< counts from the first frame that starts at or after sample 0
    double sample = 0;  ///< instant of the reading on the suit's clock, s0 + n * fs / 140
    std::array<std::optional<double>, 6>
        counts;  ///< gyro xyz, accelerometer xyz; integers when decoded from sound
    std::array<std::optional<double>, 3> magnetometer_counts;
    std::optional<int> corrected_bits;  ///< absent: the frame was lost
};

/// Frames per second of every board, clocked by the suit's sample clock.
inline constexpr int kInertialFramesPerSecond = 140;
/// Lowest and highest count mean "clipped": the truth lies there or beyond.
inline constexpr double kCountsMin = 0, kCountsMax = 4095;

}  // namespace noctule
