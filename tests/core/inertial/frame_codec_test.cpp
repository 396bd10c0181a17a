// SPDX-License-Identifier: Apache-2.0
// Encoder and decoder of aligned frames: golden streams, error statistics, noise never trusted.
#include <random>

#include "core/inertial/frame_decoder.h"
#include "core/inertial/frame_encoder.h"
#include "core/inertial/golay.h"
#include "tests/core/inertial/golden.h"

namespace noctule {
namespace {

/// A lost or silent reading is an empty cell.
void expectReadings(const InertialReading& reading, const Row& row, size_t from) {
    for (size_t axis = 0; axis < 6; ++axis) {
        const auto expected = cell(row[from + axis]);
        ASSERT_EQ(reading.counts[axis].has_value(), expected.has_value())
            << "frame " << row[0] << " axis " << axis;
        if (expected) {
            EXPECT_EQ(*reading.counts[axis], *expected) << "frame " << row[0] << " axis " << axis;
        }
    }
}

TEST(FrameEncoder, MatchesTheGoldenStream) {
    FrameEncoder encoder;
    for (const Row& row : goldenRows("stream_3s.csv")) {
        EXPECT_EQ(encoder.counter(), std::stoi(row[1]));
        const LineBits bits = encoder.encode(numbers<6>(row, 2));
        EXPECT_EQ(bits, lineBits(row[26])) << "frame " << row[0];
        EXPECT_EQ(encoder.roundingSum(), (numbers<6>(row, 20))) << "frame " << row[0];
        for (size_t axis = 0; axis < 6; ++axis)
            if (const auto out = cell(row[14 + axis])) {
                EXPECT_EQ(encoder.reconstruction()[axis], *out) << "frame " << row[0];
            }
    }
}

TEST(FrameDecoder, FollowsTheGoldenStreamFromEachAxisFirstRefreshOn) {
    FrameDecoder decoder;
    int counter = 0;
    for (Row row : goldenRows("stream_3s.csv")) {
        const InertialReading reading = decoder.decode(lineBits(row[26]), counter);
        for (int axis = 0; axis < 6; ++axis)
            if (std::stoi(row[0]) < 20 * axis)
                row[14 + axis].clear();
        expectReadings(reading, row, 14);
        EXPECT_EQ(reading.corrected_bits, 0);
        counter = nextCounter(counter);
    }
}

TEST(FrameCodec, NineAxisBoard) {
    FrameEncoder encoder(true);
    FrameDecoder decoder(true);
    for (Row row : goldenRows("stream_imu9_1s.csv")) {
        const int counter = std::stoi(row[1]);
        const LineBits bits = encoder.encode(numbers<6>(row, 2), numbers<3>(row, 8));
        ASSERT_EQ(bits, lineBits(row[17])) << "frame " << row[0];
        const InertialReading reading = decoder.decode(bits, counter);
        for (int axis = 0; axis < 6; ++axis)
            if (std::stoi(row[0]) < 20 * axis)
                row[11 + axis].clear();
        expectReadings(reading, row, 11);
        for (size_t axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(reading.magnetometer_counts[axis].has_value(), counter % 20 == 10);
            if (counter % 20 == 10) {
                EXPECT_EQ(*reading.magnetometer_counts[axis], std::stoi(row[8 + axis]));
            }
        }
    }
}

TEST(FrameDecoder, DamagedGoldenStream) {
    FrameDecoder decoder;
    const auto in = goldenRows("stream_3s_errors_in.csv"), out = goldenRows("stream_3s_errors_out.csv");
    ASSERT_EQ(in.size(), out.size());
    int counter = 0;
    for (size_t i = 0; i < in.size(); ++i, counter = nextCounter(counter)) {
        const InertialReading reading = decoder.decode(lineBits(in[i][1]), counter);
        expectReadings(reading, out[i], 1);
        const std::string state =
            reading.corrected_bits ? "ok" + std::to_string(*reading.corrected_bits) : "lost";
        EXPECT_EQ(state, out[i][7]) << "frame " << i;
    }
}

TEST(FrameDecoder, ALostMagnetometerFrameLeavesTheAxesKnown) {
    FrameEncoder encoder(true);
    FrameDecoder decoder(true);
    const std::array<int, 6> reading{2100, 2000, 2048, 1900, 2200, 3000};
    for (int frame = 0; frame < 120; ++frame)
        decoder.decode(encoder.encode(reading), frame);
    for (int counter = 0; counter < 10; ++counter)
        decoder.decode(encoder.encode(reading), counter);
    encoder.encode(reading);
    decoder.lose(10);
    const InertialReading after = decoder.decode(encoder.encode(reading), 11);
    for (int axis = 0; axis < 6; ++axis)
        EXPECT_EQ(after.counts[axis], reading[axis]);
    decoder.lose(12);
    EXPECT_FALSE(decoder.decode(LineBits{}, 13).corrected_bits);
}

TEST(FrameEncoder, RoundingIsPaidBack) {
    FrameEncoder encoder;
    int64_t error_sum = 0, largest = 0;
    for (int frame = 0; frame < 1400; ++frame) {
        std::array<int, 6> reading{};
        reading.fill(2048 + static_cast<int>(std::lround(900 * std::sin(0.21 * frame))));
        const bool axis_is_sent = frame % 20 != 0;
        encoder.encode(reading);
        if (axis_is_sent)
            error_sum += encoder.reconstruction()[1] - reading[1];
        largest = std::max(largest, std::abs(error_sum));
    }
    EXPECT_LE(largest, 200);  // without the payback it would be a random walk of rounding errors of some 30
}

struct ErrorCount {
    double lost = 0;   ///< share of frames
    double wrong = 0;  ///< share of readings that go wrong (and stay so until the axis' next refresh)
};

ErrorCount decodeAtErrorRate(double bit_error_rate, int frames) {
    std::mt19937 random(11);
    std::geometric_distribution<int> gap(bit_error_rate);
    FrameEncoder encoder;
    FrameDecoder decoder;
    int lost = 0, wrong = 0, present = 0;
    std::array<bool, 6> was_wrong{};
    int until_error = gap(random);
    for (int frame = 0; frame < frames; ++frame) {
        const int counter = encoder.counter();
        std::array<int, 6> truth{};
        for (int axis = 0; axis < 6; ++axis)
            truth[axis] = 2048 + static_cast<int>(1000 * std::sin(0.02 * (axis + 1) * frame));
        LineBits bits = encoder.encode(truth);
        for (; until_error < kBitsPerFrame; until_error += 1 + gap(random))
            bits[until_error] ^= 1;
        until_error -= kBitsPerFrame;
        const InertialReading reading = decoder.decode(bits, counter);
        lost += !reading.corrected_bits;
        for (int axis = 0; axis < 6; ++axis) {
            const bool is_wrong =
                reading.counts[axis] && *reading.counts[axis] != encoder.reconstruction()[axis];
            present += reading.counts[axis].has_value();
            wrong += is_wrong && !was_wrong[axis];
            if (reading.counts[axis])
                was_wrong[axis] = is_wrong;
        }
    }
    return {static_cast<double>(lost) / frames, static_cast<double>(wrong) / std::max(1, present)};
}

TEST(FrameDecoder, LossesAtStatedBitErrorRates) {
    EXPECT_EQ(decodeAtErrorRate(0.001, 100000).lost, 0);
    const ErrorCount at_1_percent = decodeAtErrorRate(0.01, 400000);
    EXPECT_NEAR(at_1_percent.lost, 1 / 1700.0, 1.5e-4);  // 4 sigma of 235 frames
    EXPECT_LT(at_1_percent.wrong, 2e-5);
    const ErrorCount at_3_percent = decodeAtErrorRate(0.03, 200000);
    EXPECT_NEAR(at_3_percent.lost, 0.07, 0.01);
    EXPECT_LT(at_3_percent.wrong, 1e-3);
}

TEST(FrameDecoder, NoiseIsNotTrusted) {
    std::mt19937 random(5);
    int with_header = 0;
    for (int trial = 0; trial < 300000; ++trial) {
        LineBits bits;
        for (uint8_t& bit : bits)
            bit = random() & 1;
        ASSERT_FALSE(checkFrame(bits, trial % kCounterPeriod).trusted);
        const LineBits header = packFrame(trial % kCounterPeriod, {});
        std::copy(header.begin(), header.begin() + kHeaderBits, bits.begin());
        with_header += checkFrame(bits, trial % kCounterPeriod).trusted;
    }
    EXPECT_NEAR(with_header / 300000.0, 1 / 5000.0, 1e-4);
}

}  // namespace
}  // namespace noctule
