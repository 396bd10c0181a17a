// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace noctule::simulation {
namespace {

double normalCumulative(double x) {
    return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

TEST(Random, EqualArgumentsGiveEqualStreams) {
    Random a(7, "gyro noise", 3), b(7, "gyro noise", 3);
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(a.bits(), b.bits());
}

TEST(Random, SeedNameAndIndexEachMakeAnotherStream) {
    const uint64_t first = Random(7, "gyro noise", 3).bits();
    EXPECT_NE(first, Random(8, "gyro noise", 3).bits());
    EXPECT_NE(first, Random(7, "accel noise", 3).bits());
    EXPECT_NE(first, Random(7, "gyro noise", 4).bits());
    EXPECT_NE(Random(1, "x", 2).bits(), Random(2, "x", 1).bits());
}

// Recorded once: takes made from a seed must stay what they were, on every machine.
TEST(Random, NumbersNeverChange) {
    Random random(42, "golden", 1);
    EXPECT_EQ(random.bits(), 17565603376814916678u);
    EXPECT_EQ(random.bits(), 18301238161236822063u);
    EXPECT_DOUBLE_EQ(random.uniform(), 0.18803187431020796);
    EXPECT_DOUBLE_EQ(random.gaussian(), -0.61037876433400851);
    EXPECT_DOUBLE_EQ(random.exponential(), 1.9166334055371845);
}

TEST(Random, UniformFillsItsInterval) {
    Random random(1, "uniform");
    constexpr int kCount = 1000000;
    double sum = 0, sum2 = 0, least = 1, most = 0;
    for (int i = 0; i < kCount; ++i) {
        const double u = random.uniform();
        sum += u;
        sum2 += u * u;
        least = std::min(least, u);
        most = std::max(most, u);
    }
    EXPECT_NEAR(sum / kCount, 0.5, 4 * std::sqrt(1.0 / 12 / kCount));
    EXPECT_NEAR(sum2 / kCount, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / kCount));
    EXPECT_GE(least, 0);
    EXPECT_LT(most, 1);
    EXPECT_LT(least, 1e-5);
    EXPECT_GT(most, 1 - 1e-5);
}

TEST(Random, BelowGivesEveryNumberEquallyOften) {
    Random random(2, "below");
    std::vector<int> counts(7);
    for (int i = 0; i < 70000; ++i)
        ++counts.at(static_cast<size_t>(random.below(7)));
    for (const int count : counts)
        EXPECT_NEAR(count, 10000, 4 * std::sqrt(10000 * 6.0 / 7));
}

TEST(Random, GaussianHasTheMomentsOfTheNormal) {
    Random random(3, "gaussian");
    constexpr int kCount = 10000000;
    double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
    for (int i = 0; i < kCount; ++i) {
        const double x = random.gaussian();
        m1 += x;
        m2 += x * x;
        m3 += x * x * x;
        m4 += x * x * x * x;
    }
    EXPECT_NEAR(m1 / kCount, 0, 4 * std::sqrt(1.0 / kCount));
    EXPECT_NEAR(m2 / kCount, 1, 4 * std::sqrt(2.0 / kCount));
    EXPECT_NEAR(m3 / kCount, 0, 4 * std::sqrt(15.0 / kCount));
    EXPECT_NEAR(m4 / kCount, 3, 4 * std::sqrt(96.0 / kCount));
}

// Finer than the moments: every layer of the ziggurat, its wedges and its tail.
TEST(Random, GaussianFollowsTheNormalBinByBin) {
    Random random(4, "gaussian");
    constexpr int kCount = 10000000, kBins = 400;
    constexpr double kWidth = 0.02;
    std::vector<int> counts(kBins + 2);
    for (int i = 0; i < kCount; ++i) {
        const int bin = static_cast<int>(std::floor(random.gaussian() / kWidth)) + kBins / 2;
        ++counts[static_cast<size_t>(std::clamp(bin, -1, kBins) + 1)];
    }
    double chi2 = 0;
    for (int bin = -1; bin <= kBins; ++bin) {
        const double low = bin < 0 ? -40 : (bin - kBins / 2) * kWidth;
        const double high = bin == kBins ? 40 : (bin + 1 - kBins / 2) * kWidth;
        // From the side where nothing cancels.
        const double share = low < 0 ? normalCumulative(high) - normalCumulative(low)
                                     : normalCumulative(-low) - normalCumulative(-high);
        chi2 += std::pow(counts[static_cast<size_t>(bin + 1)] - share * kCount, 2) / (share * kCount);
    }
    EXPECT_NEAR(chi2, kBins + 1, 4 * std::sqrt(2.0 * (kBins + 1)));
}

// Beyond 3.654 the ziggurat has a branch of its own; 6.33e-5 of all draws lie beyond 4, 2.67e-5 beyond 4.2.
TEST(Random, GaussianHasTheNormalTails) {
    Random random(10, "tails");
    constexpr int kCount = 50000000;
    int beyond_4 = 0, beyond_4_2 = 0;
    for (int i = 0; i < kCount; ++i) {
        const double size = std::abs(random.gaussian());
        beyond_4 += size > 4 ? 1 : 0;
        beyond_4_2 += size > 4.2 ? 1 : 0;
    }
    const double expected_4 = kCount * 2 * normalCumulative(-4),
                 expected_4_2 = kCount * 2 * normalCumulative(-4.2);
    EXPECT_NEAR(beyond_4, expected_4, 4 * std::sqrt(expected_4));
    EXPECT_NEAR(beyond_4_2, expected_4_2, 4 * std::sqrt(expected_4_2));
}

TEST(Random, StreamsAreUncorrelated) {
    Random a(5, "noise", 0), b(5, "noise", 1);
    constexpr int kCount = 1000000;
    double same = 0, shifted = 0, before = 0;
    for (int i = 0; i < kCount; ++i) {
        const double x = a.gaussian(), y = b.gaussian();
        same += x * y;
        shifted += before * x;
        before = x;
    }
    EXPECT_NEAR(same / kCount, 0, 4e-3);
    EXPECT_NEAR(shifted / kCount, 0, 4e-3);
}

TEST(Random, DirectionAndExponential) {
    Random random(6, "direction");
    constexpr int kCount = 200000;
    Vector3d sum = Vector3d::Zero();
    Matrix3d sum2 = Matrix3d::Zero();
    double waiting = 0;
    for (int i = 0; i < kCount; ++i) {
        const Vector3d v = random.direction();
        EXPECT_NEAR(v.norm(), 1, 1e-12);
        sum += v;
        sum2 += v * v.transpose();
        waiting += random.exponential();
    }
    EXPECT_LT((sum / kCount).norm(), 5e-3);
    EXPECT_LT((sum2 / kCount - Matrix3d::Identity() / 3).norm(), 5e-3);
    EXPECT_NEAR(waiting / kCount, 1, 4 / std::sqrt(kCount));
}

}  // namespace
}  // namespace noctule::simulation
