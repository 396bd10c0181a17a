// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/frame_encoder.h"

#include <algorithm>

#include "core/inertial/golay.h"
#include "core/inertial/step_table.h"
#include "core/job/contract.h"

namespace noctule {
namespace {

int saturated(int reading) {
    return std::clamp(reading, 0, 4095);
}

}  // namespace

FrameEncoder::FrameEncoder(bool imu9, int first_counter) : imu9_(imu9), counter_(first_counter) {
    require(first_counter >= 0 && first_counter < kCounterPeriod, "FrameEncoder: counter out of range");
}

uint32_t FrameEncoder::codeFor(int axis, int reading) {
    const bool clipped =
        reading == 0 || reading == 4095;  // a sum kept while clipped would be paid back later
    const int code = nearestCode(reconstruction_[axis], clipped ? reading : reading - rounding_sum_[axis]);
    reconstruction_[axis] = stepped(reconstruction_[axis], code);
    if (!clipped)
        rounding_sum_[axis] = std::clamp(rounding_sum_[axis] + reconstruction_[axis] - reading, -200, 200);
    return static_cast<uint32_t>(code);
}

LineBits FrameEncoder::encode(const std::array<int, 6>& reading, const std::array<int, 3>& magnetometer) {
    std::array<uint32_t, 3> words{};
    const FrameContent content = frameContent(counter_, imu9_);
    for (size_t w = 0; w < words.size(); ++w) {
        const auto [kind, first, second] = content[w];
        uint32_t data = 0;
        if (kind == WordContent::Kind::kMagnetometer) {
            data = static_cast<uint32_t>(saturated(magnetometer[first]));
        } else if (kind == WordContent::Kind::kReading) {
            reconstruction_[first] = saturated(reading[first]);
            data = static_cast<uint32_t>(reconstruction_[first]);
        } else {
            data = codeFor(first, saturated(reading[first])) << 6;
            data |= codeFor(second, saturated(reading[second]));
        }
        words[w] = golayEncode(data);
    }
    const LineBits bits = packFrame(counter_, words);
    counter_ = nextCounter(counter_);
    return bits;
}

}  // namespace noctule
