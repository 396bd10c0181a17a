// SPDX-License-Identifier: Apache-2.0
#include "core/live/levels.h"

#include <gtest/gtest.h>

#include "core/live/heard_window.h"
#include "core/live/sliding_maximum.h"

namespace noctule {
namespace {

TEST(Levels, AreDecibelsBelowFullScale) {
    EXPECT_DOUBLE_EQ(level_db(kWireFullScale_counts, kWireFullScale_counts), 0);
    EXPECT_NEAR(level_db(kWireFullScale_counts / 2, kWireFullScale_counts), -6.02, 0.01);
    EXPECT_EQ(level_db(0, kWireFullScale_counts), kSilence_db);
    EXPECT_EQ(level_db(0.001, kWireFullScale_counts), kSilence_db);
}

InertialReading turning(std::optional<double> x, double y, double z) {
    InertialReading reading;
    reading.counts = {x, y, z, 2048.0, 2048.0, 2048.0};
    return reading;
}

TEST(Levels, MotionIsTheTurningOfAllThreeAxes) {
    EXPECT_EQ(motionLevel_db(turning(2048, 2048, 2048)), kSilence_db);
    EXPECT_NEAR(*motionLevel_db(turning(2048 + 300, 2048 - 400, 2048)), 20 * std::log10(500 / 2048.0), 1e-9);
    EXPECT_EQ(*motionLevel_db(turning(0, 0, 4095)), 0) << "more than full scale of one axis is full";
    EXPECT_FALSE(motionLevel_db(turning(std::nullopt, 2100, 2048)));
}

TEST(MeterNeedle, RisesAtOnceAndFallsTwentyDecibelsASecond) {
    MeterNeedle needle;
    needle.show(-6, 1);
    EXPECT_EQ(needle.level(), -6);
    needle.show(-60, 1.5);
    EXPECT_NEAR(needle.level(), -16, 1e-9);
    needle.show(-60, 2);
    EXPECT_NEAR(needle.level(), -26, 1e-9);
    needle.show(-20, 2.1);
    EXPECT_EQ(needle.level(), -20);
    needle.show(-60, 20);
    EXPECT_EQ(needle.level(), -60);
}

TEST(MeterNeedle, ThePeakStaysForOneAndAHalfSeconds) {
    MeterNeedle needle;
    needle.show(-6, 1);
    needle.show(-60, 2.5);
    EXPECT_EQ(needle.peak(), -6);
    needle.show(-60, 3);
    EXPECT_NEAR(needle.peak(), -16, 1e-9) << "half a second after the hold";
    needle.show(-3, 3.1);
    EXPECT_EQ(needle.peak(), -3) << "a louder one takes its place at once";
    needle.show(-60, 4.5);
    EXPECT_EQ(needle.peak(), -3);
}

TEST(MeterNeedle, StepsOfAnySizeFallAlike) {
    MeterNeedle fine, coarse;
    fine.show(0, 0), coarse.show(0, 0);
    for (int i = 1; i <= 200; ++i)
        fine.show(-90, 0.01 * i);
    coarse.show(-90, 2);
    EXPECT_NEAR(fine.level(), coarse.level(), 1e-9);
    EXPECT_NEAR(fine.peak(), coarse.peak(), 1e-9);
}

TEST(SlidingMaximum, ForgetsWhatIsOlderThanItsWindow) {
    SlidingMaximum maximum(100);
    EXPECT_EQ(maximum.value(), 0);
    maximum.add(0, 7);
    maximum.add(50, 3);
    maximum.add(60, 5);
    EXPECT_EQ(maximum.value(), 7);
    maximum.advanceTo(100);
    EXPECT_EQ(maximum.value(), 7);
    maximum.advanceTo(101);
    EXPECT_EQ(maximum.value(), 5);
    maximum.advanceTo(161);
    EXPECT_EQ(maximum.value(), 0);
}

class HeardWindowTest : public testing::Test {
protected:
    static constexpr int kRate_hz = 1000, kBoards = 2;
    void hear(int source, int board, int64_t pulse_sample, double confidence) {
        RangeMeasurement range;
        range.source = source, range.board = board, range.pulse_sample = pulse_sample;
        range.w_s = confidence, range.w_t = 1;
        newest_[static_cast<size_t>(source * kBoards + board)] = range;
        window_.add(newest_);
    }
    std::vector<std::optional<RangeMeasurement>> newest_ =
        std::vector<std::optional<RangeMeasurement>>(2 * kBoards);
    HeardWindow window_{2, kBoards, kRate_hz, {1, 0.1}};
};

TEST_F(HeardWindowTest, IsTheMeanOfTheBoardsThatHeardTheSource) {
    EXPECT_EQ(window_.stepCount(), 10);
    hear(0, 0, 20, 0.9);
    hear(0, 1, 20, 0.5);
    hear(1, 0, 28, 0.25);
    EXPECT_NEAR(*window_.confidence(0, 9), 0.7, 1e-9);
    EXPECT_NEAR(*window_.confidence(1, 9), 0.25, 1e-9);
    EXPECT_FALSE(window_.confidence(0, 8));
}

TEST_F(HeardWindowTest, CountsARangeOnce) {
    hear(0, 0, 20, 1);
    window_.add(newest_);
    window_.add(newest_);
    hear(0, 1, 20, 0.5);
    EXPECT_NEAR(*window_.confidence(0, 9), 0.75, 1e-9);
}

TEST_F(HeardWindowTest, MovesOnAndForgets) {
    hear(0, 0, 20, 0.8);
    window_.advanceTo(950);
    EXPECT_NEAR(*window_.confidence(0, 0), 0.8, 1e-9);
    EXPECT_FALSE(window_.confidence(0, 9));
    window_.advanceTo(1000);
    for (int step = 0; step < window_.stepCount(); ++step)
        EXPECT_FALSE(window_.confidence(0, step)) << step;
    hear(0, 0, 1010, 0.3);
    EXPECT_NEAR(*window_.confidence(0, 9), 0.3, 1e-9);
}

}  // namespace
}  // namespace noctule
