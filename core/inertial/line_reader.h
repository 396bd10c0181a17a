// SPDX-License-Identifier: Apache-2.0
// Takes the 92 bits of one frame out of a board's samples: filters at each bit's middle and slices between
// the two levels that the frame itself shows, so that an offset or a drift slower than a frame does no harm.
#pragma once

#include <array>

#include "core/inertial/frame_layout.h"
#include "core/inertial/line_filter.h"
#include "core/inertial/sample_buffer.h"

namespace noctule {

struct ReadFrame {
    LineBits bits{};
    std::array<float, kBitsPerFrame> middles{};  ///< filtered samples at mid-bit, counts
    double offset = 0;                           ///< halfway between the levels of ones and zeros, counts
    double level = 0;                            ///< half their distance, counts; 0 when all bits are alike
};

ReadFrame readFrame(const SampleBuffer& samples, const LineFilter& filter, const BitClock& clock,
                    int64_t frame);

}  // namespace noctule
