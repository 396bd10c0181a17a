// SPDX-License-Identifier: Apache-2.0
// What the 92 line bits of one frame are: 13 sync, 7 counter, 72 interleaved and scrambled payload bits of
// three Golay words; and what the words carry. core/inertial/README.md sections 2, 4 and 5.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>

#include "core/inertial/bit_clock.h"
#include "core/inertial/reading.h"

namespace noctule {

/// Line bits in the order of sending, each 0 or 1.
using LineBits = std::array<uint8_t, kBitsPerFrame>;

inline constexpr int kSyncBits = 13, kCounterBits = 7, kPayloadBits = 72;
inline constexpr int kHeaderBits = kSyncBits + kCounterBits;
inline constexpr uint32_t kSync = 0b1111100110101;  ///< Barker 13, first bit highest
inline constexpr int kCounterPeriod = 120;          ///< the frame counter runs 0..119

/// After so long a stream's counters, and so its scrambling, come at the same samples again.
inline constexpr int kStreamPeriod_s =
    std::lcm(kCounterPeriod, kInertialFramesPerSecond) / kInertialFramesPerSecond;

constexpr int nextCounter(int counter) {
    return (counter + 1) % kCounterPeriod;
}

/// What one 12-bit word carries.
struct WordContent {
    enum class Kind {
        kCodes,         ///< the delta codes of axis first (upper six bits) and axis second
        kReading,       ///< the absolute reading of axis first
        kMagnetometer,  ///< the absolute reading of magnetometer axis first
    } kind;
    int first = 0, second = 0;
};
using FrameContent = std::array<WordContent, 3>;

/// Follows from the counter and the board's kind alone. A refresh of axis a carries nothing of (a + 3) % 6.
FrameContent frameContent(int counter, bool imu9);

/// The sequence that whitens the payload of the frame with that counter; 0 or 1 each.
std::array<uint8_t, kPayloadBits> scramblingSequence(int counter);

/// Header and payload of the frame of that counter; each word is a 24-bit codeword.
LineBits packFrame(int counter, const std::array<uint32_t, 3>& words);

struct UnpackedFrame {
    uint32_t sync = 0;
    int counter = 0;  ///< as received, 0..127
    std::array<uint32_t, 3> words{};
};
/// Inverse of packFrame; the payload is unscrambled as that of `expected_counter`.
UnpackedFrame unpackFrame(const LineBits& bits, int expected_counter);

/// The seven counter bits as received.
int receivedCounter(const LineBits& bits);

}  // namespace noctule
