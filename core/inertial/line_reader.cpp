// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/line_reader.h"

namespace noctule {
namespace {

// Slicing at the mean and again halfway between the two groups' means: the mean alone is off by up to a third
// of the amplitude when a frame holds more ones than zeros.
void slice(ReadFrame& frame) {
    double sum = 0;
    for (float v : frame.middles)
        sum += v;
    frame.offset = sum / kBitsPerFrame;
    for (int round = 0; round < 3; ++round) {
        double sum_of_ones = 0;
        int ones = 0;
        for (int i = 0; i < kBitsPerFrame; ++i) {
            frame.bits[i] = frame.middles[i] > frame.offset;
            ones += frame.bits[i];
            sum_of_ones += frame.bits[i] ? frame.middles[i] : 0;
        }
        if (ones == 0 || ones == kBitsPerFrame)
            return;
        const double high = sum_of_ones / ones, low = (sum - sum_of_ones) / (kBitsPerFrame - ones);
        frame.offset = (high + low) / 2;
        frame.level = (high - low) / 2;
    }
}

}  // namespace

ReadFrame readFrame(const SampleBuffer& samples, const LineFilter& filter, const BitClock& clock,
                    int64_t frame) {
    ReadFrame read;
    for (int i = 0; i < kBitsPerFrame; ++i)
        read.middles[i] = filter(samples.at(filter.middleOfBit(clock, frame * kBitsPerFrame + i)));
    slice(read);
    return read;
}

}  // namespace noctule
