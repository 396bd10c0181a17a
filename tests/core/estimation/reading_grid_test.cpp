// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/reading_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace noctule {
namespace {

constexpr double kEvery_s = 1.0 / 140, kPhase_s = 0.0031;

/// A limb that swings at 5 Hz: gyroscope x and accelerometer z.
double swing(double t_s) {
    return 8 * std::sin(2 * std::numbers::pi * 5 * t_s);
}

InertialMeasurement readingAt(double t_s) {
    InertialMeasurement m{0, t_s, {}, {}};
    m.gyro.add({Vector3d::UnitX(), swing(t_s), 0.01});
    m.accel.add({-Vector3d::UnitZ(), -swing(t_s), 0.1});
    return m;
}

TEST(ReadingGrid, ReadsASwingBetweenItsReadings) {
    ReadingGrid grid(1);
    double worst = 0, worst_held = 0;
    for (int k = 0; k < 140; ++k) {
        grid.add(readingAt(k * kEvery_s + kPhase_s));
        if (k < 4)
            continue;
        const double t_s = k * kEvery_s;
        const auto readings = grid.at(t_s);
        ASSERT_EQ(readings.size(), 1u);
        EXPECT_EQ(readings[0].time_s, t_s);
        worst = std::max(worst, std::abs(readings[0].gyro.axes[0].value - swing(t_s)));
        EXPECT_NEAR(readings[0].accel.axes[0].value, -swing(t_s), 0.005);
        EXPECT_EQ(readings[0].accel.axes[0].sigma, 0.1);
        worst_held = std::max(worst_held, std::abs(swing(t_s) - swing(t_s - kEvery_s + kPhase_s)));
    }
    EXPECT_LT(worst, 0.005);
    EXPECT_GT(worst_held, 100 * worst) << "or the swing shows nothing";
}

TEST(ReadingGrid, ReadingsOnTheGridStayAsTheyAre) {
    ReadingGrid grid(1);
    for (int k = 0; k < 5; ++k)
        grid.add(readingAt(k * kEvery_s));
    EXPECT_EQ(grid.at(3 * kEvery_s)[0].gyro.axes[0].value, swing(3 * kEvery_s));
}

TEST(ReadingGrid, AnAxisThatIsSilentForLongIsMissing) {
    ReadingGrid grid(1);
    for (int k : {0, 1, 2, 4, 8})  // at 3 one reading is missing, from 5 on three
        grid.add(readingAt(k * kEvery_s + kPhase_s));
    EXPECT_TRUE(grid.at(3 * kEvery_s).empty()) << "the next reading is more than a frame away";
    ASSERT_EQ(grid.at(4 * kEvery_s).size(), 1u);
    EXPECT_TRUE(grid.at(6 * kEvery_s).empty());
    EXPECT_TRUE(grid.at(8 * kEvery_s).empty());
}

TEST(ReadingGrid, WhatLiesAheadOfItsReachChangesNothing) {
    ReadingGrid now(1), later(1);
    for (int k = 0; k < 6; ++k)
        now.add(readingAt(k * kEvery_s + kPhase_s));
    for (int k = 0; k < 20; ++k)
        later.add(readingAt(k * kEvery_s + kPhase_s));
    EXPECT_EQ(now.at(5 * kEvery_s)[0].gyro.axes[0].value, later.at(5 * kEvery_s)[0].gyro.axes[0].value);
}

TEST(ReadingGrid, NextToAClippedReadingNothingIsInvented) {
    ReadingGrid grid(1);
    for (int k = 0; k < 6; ++k) {
        InertialMeasurement m = readingAt(k * kEvery_s + kPhase_s);
        if (k == 3)
            m.gyro.axes[0].beyond = 1;
        grid.add(m);
    }
    // 3.1 of 7.1 ms after the clipped reading's frame began: before it the nearer one is clipped, after it
    // not.
    const auto before = grid.at(3 * kEvery_s);
    ASSERT_EQ(before.size(), 1u);
    EXPECT_EQ(before[0].gyro.axes[0].beyond, 1);
    EXPECT_EQ(before[0].gyro.axes[0].value, swing(3 * kEvery_s + kPhase_s));
    const auto after = grid.at(4 * kEvery_s);
    ASSERT_EQ(after.size(), 1u);
    EXPECT_EQ(after[0].gyro.count, 0);
    EXPECT_EQ(after[0].accel.count, 1);
}

}  // namespace
}  // namespace noctule
