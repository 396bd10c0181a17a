// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/frame_layout.h"

#include <vector>

#include "core/job/contract.h"

namespace noctule {
namespace {

using Sequence = std::array<uint8_t, kPayloadBits>;

Sequence scramble(int counter) {
    Sequence sequence;
    uint32_t shift_register = 0x100u | static_cast<uint32_t>(counter);
    for (uint8_t& out : sequence) {
        out = shift_register >> 8 & 1;
        const uint32_t feedback = (shift_register >> 8 ^ shift_register >> 4) & 1;
        shift_register = (shift_register << 1 | feedback) & 0x1FF;
    }
    return sequence;
}

void putBits(LineBits& bits, int at, int count, uint32_t value) {
    for (int i = 0; i < count; ++i)
        bits[at + i] = value >> (count - 1 - i) & 1;
}

uint32_t getBits(const LineBits& bits, int at, int count) {
    uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value = value << 1 | bits[at + i];
    return value;
}

}  // namespace

FrameContent frameContent(int counter, bool imu9) {
    require(counter >= 0 && counter < kCounterPeriod, "frameContent: counter out of range");
    using Kind = WordContent::Kind;
    if (imu9 && counter % 20 == 10)
        return {{{Kind::kMagnetometer, 0}, {Kind::kMagnetometer, 1}, {Kind::kMagnetometer, 2}}};
    if (counter % 20 != 0)
        return {{{Kind::kCodes, 0, 1}, {Kind::kCodes, 2, 3}, {Kind::kCodes, 4, 5}}};
    const int refreshed = counter / 20, silent = (refreshed + 3) % 6;
    std::array<int, 4> remaining{};
    for (int axis = 0, n = 0; axis < 6; ++axis)
        if (axis != refreshed && axis != silent)
            remaining[n++] = axis;
    return {{{Kind::kReading, refreshed},
             {Kind::kCodes, remaining[0], remaining[1]},
             {Kind::kCodes, remaining[2], remaining[3]}}};
}

Sequence scramblingSequence(int counter) {
    require(counter >= 0 && counter < kCounterPeriod, "scramblingSequence: counter out of range");
    static const std::vector<Sequence> sequences = [] {
        std::vector<Sequence> all;
        for (int c = 0; c < kCounterPeriod; ++c)
            all.push_back(scramble(c));
        return all;
    }();
    return sequences[counter];
}

LineBits packFrame(int counter, const std::array<uint32_t, 3>& words) {
    LineBits bits;
    putBits(bits, 0, kSyncBits, kSync);
    putBits(bits, kSyncBits, kCounterBits, static_cast<uint32_t>(counter));
    const Sequence sequence = scramblingSequence(counter);
    for (int i = 0; i < kPayloadBits; ++i)
        bits[kHeaderBits + i] = (words[i % 3] >> (23 - i / 3) & 1) ^ sequence[i];
    return bits;
}

UnpackedFrame unpackFrame(const LineBits& bits, int expected_counter) {
    UnpackedFrame frame{getBits(bits, 0, kSyncBits), receivedCounter(bits), {}};
    const Sequence sequence = scramblingSequence(expected_counter);
    for (int i = 0; i < kPayloadBits; ++i)
        frame.words[i % 3] = frame.words[i % 3] << 1 | (bits[kHeaderBits + i] ^ sequence[i]);
    return frame;
}

int receivedCounter(const LineBits& bits) {
    return static_cast<int>(getBits(bits, kSyncBits, kCounterBits));
}

}  // namespace noctule
