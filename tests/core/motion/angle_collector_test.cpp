// SPDX-License-Identifier: Apache-2.0
#include "core/motion/angle_collector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace noctule {
namespace {

/// Exponential quantiles are known: -ln(1 - share) times the mean.
TEST(AngleCollector, QuantilesAreThoseOfTheDistribution) {
    AngleCollector angle;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i)
        angle.add(i, radians(-4 * std::log(1 - (i + 0.5) / kCount)));
    const AngleStatistics found = angle.statistics();
    EXPECT_NEAR(found.mean_deg, 4, 0.01);
    EXPECT_NEAR(found.median_deg, 4 * std::log(2), 0.01);
    EXPECT_NEAR(found.p95_deg, 4 * std::log(20), 0.01);
}

TEST(AngleCollector, NothingAndHalfATurnAreHarmless) {
    AngleCollector angle;
    EXPECT_EQ(angle.statistics().median_deg, 0);
    angle.add(0, std::numbers::pi);
    EXPECT_NEAR(angle.statistics().p95_deg, 180, 0.01);
}

}  // namespace
}  // namespace noctule
