// SPDX-License-Identifier: Apache-2.0
// Golay code, step table, scrambling and bit boundaries against the golden vectors.
#include <bit>
#include <random>

#include "core/inertial/bit_clock.h"
#include "core/inertial/golay.h"
#include "core/inertial/step_table.h"
#include "tests/core/inertial/golden.h"

namespace noctule {
namespace {

uint32_t hex(const std::string& text) {
    return static_cast<uint32_t>(std::stoul(text, nullptr, 16));
}

TEST(Golay, EncodesEveryWord) {
    const auto rows = goldenRows("golay_words.csv");
    ASSERT_EQ(rows.size(), 4096u);
    for (const Row& row : rows)
        EXPECT_EQ(golayEncode(hex(row[0])), hex(row[1])) << row[0];
}

TEST(Golay, DecodesReceivedWords) {
    for (const Row& row : goldenRows("golay_decode.csv")) {
        const auto decoded = golayDecode(hex(row[0]));
        ASSERT_EQ(decoded.has_value(), row[1] != "X") << row[0];
        if (decoded) {
            EXPECT_EQ(decoded->data, hex(row[1])) << row[0];
        }
        if (decoded && std::stoi(row[2]) <= 3) {
            EXPECT_EQ(decoded->corrected_bits, std::stoi(row[2])) << row[0];
        }
    }
}

TEST(Golay, CorrectsThreeBitsAndNeverGuessesAtFour) {
    std::mt19937 random(7);
    int correctable = 0;
    for (int trial = 0; trial < 100000; ++trial) {
        const auto word = static_cast<uint32_t>(random() & 0xFFFFFF);
        const auto decoded = golayDecode(word);
        correctable += decoded.has_value();
        if (decoded) {
            EXPECT_EQ(std::popcount(golayEncode(decoded->data) ^ word), decoded->corrected_bits);
            EXPECT_LE(decoded->corrected_bits, 3);
        }
    }
    EXPECT_NEAR(correctable / 100000.0, 4096.0 * (1 + 24 + 276 + 2024) / (1 << 24), 0.01);  // 57 %
}

TEST(StepTable, IsTheSpecifiedOne) {
    for (const Row& row : goldenRows("step_table.csv"))
        EXPECT_EQ(kSteps[std::stoi(row[0])], std::stoi(row[1]));
}

TEST(StepTable, TiesTakeTheSmallerStep) {
    EXPECT_EQ(kSteps[nearestCode(2000, 2007)], 6);  // 6 and 8 are equally near
    EXPECT_EQ(kSteps[nearestCode(2000, 1993)], -6);
    EXPECT_EQ(kSteps[nearestCode(4090, 4200)], 5);  // any larger step saturates to the same 4095
    EXPECT_EQ(kSteps[nearestCode(10, -150)], -10);
}

TEST(StepTable, RoundingSigmaIsThatOfUniformErrors) {
    EXPECT_NEAR(codecRoundingSigmaCounts(0), 1 / std::sqrt(12), 1e-12);
    EXPECT_NEAR(codecRoundingSigmaCounts(-3.2), 1 / std::sqrt(12), 1e-12);
    EXPECT_EQ(codecRoundingSigmaCounts(142), codecRoundingSigmaCounts(-142));
    // Steps drawn evenly around 347 (neighbours 278 and 434), rounded by the code itself.
    double sum_of_squares = 0;
    int count = 0;
    for (int step = (278 + 347) / 2 + 1; step <= (347 + 434) / 2; ++step, ++count) {
        const double error = kSteps[nearestCode(1000, 1000 + step)] - step;
        sum_of_squares += error * error;
    }
    EXPECT_NEAR(codecRoundingSigmaCounts(350), std::sqrt(sum_of_squares / count), 0.5);
    EXPECT_NEAR(codecRoundingSigmaCounts(1e9), 332 / std::sqrt(12), 1e-9);
    EXPECT_NEAR(codecRoundingSigmaCounts(-1e9), 390 / std::sqrt(12), 1e-9);
    EXPECT_THROW(codecRoundingSigmaCounts(std::nan("")), std::logic_error);
}

TEST(Scrambling, MatchesEveryCounter) {
    const auto rows = goldenRows("scrambler.csv");
    ASSERT_EQ(rows.size(), static_cast<size_t>(kCounterPeriod));
    for (const Row& row : rows) {
        std::string text;
        for (uint8_t bit : scramblingSequence(std::stoi(row[0])))
            text += bit ? '1' : '0';
        EXPECT_EQ(text, row[1]);
    }
}

TEST(FrameLayout, UnpackIsTheInverseOfPack) {
    std::mt19937 random(3);
    for (int counter = 0; counter < kCounterPeriod; ++counter) {
        std::array<uint32_t, 3> words{};
        for (uint32_t& word : words)
            word = static_cast<uint32_t>(random() & 0xFFFFFF);
        const UnpackedFrame frame = unpackFrame(packFrame(counter, words), counter);
        EXPECT_EQ(frame.sync, kSync);
        EXPECT_EQ(frame.counter, counter);
        EXPECT_EQ(frame.words, words);
    }
}

TEST(BitClock, BoundariesAreExactForAnyRateAndPhase) {
    for (const Row& row : goldenRows("bit_boundaries.csv")) {
        const BitClock clock = BitClock::startingAt(std::stoll(row[0]), std::stoll(row[1]));
        const int64_t bit = std::stoll(row[2]), first = std::stoll(row[3]);
        EXPECT_EQ(clock.firstSampleOfBit(bit), first) << row[0] << ' ' << row[1] << ' ' << row[2];
        EXPECT_EQ(clock.bitOfSample(first), bit);
        EXPECT_EQ(clock.bitOfSample(first - 1), bit - 1);
    }
}

}  // namespace
}  // namespace noctule
