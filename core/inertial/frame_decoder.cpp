// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/frame_decoder.h"

#include <bit>

#include "core/inertial/golay.h"
#include "core/inertial/step_table.h"

namespace noctule {

CheckedFrame checkFrame(const LineBits& bits, int expected_counter) {
    const UnpackedFrame received = unpackFrame(bits, expected_counter);
    CheckedFrame frame;
    frame.wrong_sync_bits = std::popcount(received.sync ^ kSync);
    frame.received_counter = received.counter;
    frame.wrong_bits =
        frame.wrong_sync_bits + std::popcount(static_cast<uint32_t>(received.counter ^ expected_counter));
    for (size_t w = 0; w < received.words.size(); ++w) {
        const auto decoded = golayDecode(received.words[w]);
        if (!decoded)
            return frame;
        frame.words[w] = decoded->data;
        frame.wrong_bits += decoded->corrected_bits;
    }
    frame.trusted = frame.wrong_bits <= kMostWrongBits;
    return frame;
}

InertialReading FrameDecoder::decode(const CheckedFrame& frame, int counter) {
    if (!frame.trusted)
        return lose(counter);
    InertialReading reading;
    reading.corrected_bits = frame.wrong_bits;
    const FrameContent content = frameContent(counter, imu9_);
    for (size_t w = 0; w < content.size(); ++w)
        takeWord(content[w], static_cast<int>(frame.words[w]), reading);
    return reading;
}

void FrameDecoder::takeWord(const WordContent& content, int data, InertialReading& reading) {
    switch (content.kind) {
        case WordContent::Kind::kMagnetometer:
            reading.magnetometer_counts[content.first] = data;
            break;
        case WordContent::Kind::kReading:
            reconstruction_[content.first] = data;
            reading.counts[content.first] = data;
            break;
        case WordContent::Kind::kCodes:
            takeCode(content.first, data >> 6, reading);
            takeCode(content.second, data & 63, reading);
            break;
    }
}

void FrameDecoder::takeCode(int axis, int code, InertialReading& reading) {
    auto& x = reconstruction_[axis];
    if (!x)
        return;
    x = stepped(*x, code);
    reading.counts[axis] = *x;
}

InertialReading FrameDecoder::lose(int counter) {
    for (const WordContent& content : frameContent(counter, imu9_)) {
        if (content.kind == WordContent::Kind::kMagnetometer)
            continue;
        reconstruction_[content.first].reset();
        if (content.kind == WordContent::Kind::kCodes)
            reconstruction_[content.second].reset();
    }
    return {};
}

}  // namespace noctule
