// SPDX-License-Identifier: Apache-2.0
#include "core/live/health.h"

#include <random>

#include "core/live/latency.h"
#include "tests/core/live/worn_tiny_take.h"

namespace noctule {
namespace {

using test::WornTinyTake;

TEST(Health, OfTheTinyTake) {
    const WornTinyTake worn = test::wornTinyTake();
    auto pipeline = std::move(
        LivePipeline::create(worn.suit, worn.calibration, worn.actor, {{worn.train}, {}, worn.rest}).value());
    HealthMonitor health(worn.suit, 150000);
    for (const Pulse& pulse : worn.pulses)
        pipeline->pushPulse(pulse);
    for (int64_t at = 0; at + 600 <= worn.sampleCount(); at += 600) {
        pipeline->pushBlock(at, worn.samples(at, at + 600));
        health.addBlock(at, worn.samples(at, at + 600));
        for (const InertialReading& reading : pipeline->takeReadings())
            health.add(reading);
        for (const RangeMeasurement& range : pipeline->takeRanges())
            health.add(range);
    }
    health.add(SuitStatus{300000, 22.7, 43.0, 4.05, 85.0});
    const HealthReport report = health.report();
    EXPECT_EQ(report.sample, 302400);
    EXPECT_EQ(report.suit.battery_percent, 85.0);
    for (const BoardHealth& board : report.boards) {
        EXPECT_NEAR(board.frames_per_s, 140, 4);
        EXPECT_EQ(board.frames_lost, 0);
        EXPECT_FALSE(board.silent);
        EXPECT_GT(board.signal_counts, 100);
        EXPECT_EQ(board.clipped_samples, 0);
    }
    EXPECT_TRUE(std::ranges::any_of(report.pairs, [](const PairHealth& pair) {
        return pair.age_s && *pair.age_s < 0.2 && pair.confidence > 0.1;
    }));
}

Suit smallestSuit() {
    Suit suit;
    suit.boards.resize(1);
    suit.sources.resize(1);
    return suit;
}

/// A second of readings of one board whose gyroscope turns to and fro.
HealthReport afterASecond(double swing_counts, int lost_every) {
    HealthMonitor health(smallestSuit(), 150000);
    health.addBlock(0, std::vector<int16_t>(150000, 5));
    for (int frame = 0; frame < 140; ++frame) {
        InertialReading reading;
        reading.frame = frame;
        reading.sample = frame * 150000.0 / 140;
        if (lost_every == 0 || frame % lost_every != 0) {
            reading.corrected_bits = 1;
            reading.counts.fill(2048 + swing_counts * (frame % 2));
        }
        health.add(reading);
    }
    return health.report();
}

TEST(Health, CountsFramesBitsAndStillness) {
    const BoardHealth still = afterASecond(1, 0).boards[0];
    EXPECT_EQ(still.frames_per_s, 140);
    EXPECT_EQ(still.bits_corrected, 140);
    EXPECT_TRUE(still.still);
    EXPECT_DOUBLE_EQ(still.signal_counts, 5);
    const BoardHealth moving = afterASecond(40, 0).boards[0];
    EXPECT_FALSE(moving.still);
    const BoardHealth lossy = afterASecond(0, 10).boards[0];
    EXPECT_EQ(lossy.frames_lost, 14);
    EXPECT_EQ(lossy.frames_lost_in_all, 14);
    EXPECT_EQ(lossy.frames_per_s, 126);
    EXPECT_EQ(afterASecond(3000, 0).boards[0].clipped_readings, 6 * 70);
}

TEST(Health, WhatIsOldIsForgotten) {
    HealthMonitor health(smallestSuit(), 150000);
    std::vector<int16_t> loud(150000, 32767);
    health.addBlock(0, loud);
    health.add(RangeMeasurement{1, 75000, 0, 0, 75400, 0.9, 1, 0.5, 1, 0.002});
    EXPECT_EQ(health.report().boards[0].clipped_samples, 150000);
    EXPECT_EQ(health.report().boards[0].peak_counts, 32767);
    EXPECT_EQ(health.report().boards[0].ranges_per_s, 1);
    for (int64_t at = 150000; at < 450000; at += 600)
        health.addBlock(at, std::vector<int16_t>(600, 0));
    const HealthReport later = health.report();
    EXPECT_EQ(later.boards[0].clipped_samples, 0);
    EXPECT_EQ(later.boards[0].peak_counts, 0);
    EXPECT_EQ(later.boards[0].ranges_per_s, 0);
    EXPECT_TRUE(later.boards[0].silent);
    EXPECT_DOUBLE_EQ(*later.pair(0, 0).age_s, 2.5);
    EXPECT_EQ(later.pair(0, 0).confidence, 0.5);
}

TEST(Health, APairIsHeardWhateverThePoseMakesOfIt) {
    HealthMonitor health(smallestSuit(), 150000);
    RangeMeasurement range{1, 75000, 0, 0, 75400, 0.9, 1, 0.5, 1, 0.002};
    range.w_a = 0;
    health.add(range);
    EXPECT_EQ(health.report().pair(0, 0).confidence, 0);
    EXPECT_EQ(health.report().pair(0, 0).heard, 0.5);
}

TEST(Latency, QuantilesWithinOnePercent) {
    LatencyHistogram latency;
    EXPECT_EQ(latency.quantile_s(0.5), 0);
    for (int64_t i = 1; i <= 10000; ++i)
        latency.add(i * 10'000);
    EXPECT_NEAR(latency.quantile_s(0.5), 0.05, 0.0006);
    EXPECT_NEAR(latency.quantile_s(0.999), 0.0999, 0.001);
    EXPECT_EQ(latency.worst_ns(), 100'000'000);
    latency.add(int64_t{1} << 60);
    EXPECT_EQ(latency.count(), 10001);
}

}  // namespace
}  // namespace noctule
