// SPDX-License-Identifier: Apache-2.0
// Smoothers in a world that is as the filter assumes: what they gain, whether their sigmas are honest, and
// that stretches and lags leave no seam.
#include "core/estimation/smoothing_filter.h"

#include <gtest/gtest.h>

#include "tests/core/estimation/judged_run.h"

namespace noctule {
namespace {

using testing::judge;
using testing::Judged;
using testing::spool;
using testing::World;

double largestDifference(const Judged& a, const Judged& b) {
    EXPECT_EQ(a.poses.size(), b.poses.size());
    double largest = 0;
    for (size_t i = 0; i < std::min(a.poses.size(), b.poses.size()); ++i) {
        EXPECT_EQ(a.poses[i].time_ns, b.poses[i].time_ns);
        largest = std::max(largest, (a.poses[i].pose->p_world_root - b.poses[i].pose->p_world_root).norm());
        for (size_t j = 0; j < a.poses[i].pose->q_parent_joint.size(); ++j)
            largest = std::max(largest, a.poses[i].pose->q_parent_joint[j].angularDistance(
                                            b.poses[i].pose->q_parent_joint[j]));
        for (size_t k = 0; k < a.poses[i].sigma_rad.size(); ++k)
            largest = std::max(largest, std::abs(a.poses[i].sigma_rad[k] - b.poses[i].sigma_rad[k]));
    }
    return largest;
}

TEST(SmoothingFilter, GainsAndIsHonest) {
    for (const SensorSelection sensors :
         {SensorSelection{true, true, true}, SensorSelection{false, true, true}}) {
        const ManifoldParameters parameters = testing::fittingParameters(sensors, true);
        double filter_deg = 0, lag_deg = 0, full_deg = 0, filter_nees = 0, lag_nees = 0, full_nees = 0;
        constexpr int kRuns = 8;
        for (unsigned seed = 1; seed <= kRuns; ++seed) {
            World world(parameters, seed);
            ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
            FixedLagSmoother lag(testing::smallSkeleton(), world.suit, parameters, 0.5, 0.1);
            FixedIntervalSmoother full(testing::smallSkeleton(), world.suit, parameters, spool());
            const Judged filtered = judge(filter, parameters, seed, 3);
            filter_deg += filtered.rms_deg / kRuns;
            filter_nees += filtered.nees / kRuns;
            const Judged lagging = judge(lag, parameters, seed, 3), whole = judge(full, parameters, seed, 3);
            lag_deg += lagging.rms_deg / kRuns;
            full_deg += whole.rms_deg / kRuns;
            lag_nees += lagging.nees / kRuns;
            full_nees += whole.nees / kRuns;
        }
        std::printf("degrees rms: filter %.4f, lag %.4f, full %.4f; NEES %.2f, %.2f, %.2f\n", filter_deg,
                    lag_deg, full_deg, filter_nees, lag_nees, full_nees);
        EXPECT_LT(lag_deg, 0.9 * filter_deg);
        EXPECT_LT(full_deg, lag_deg);
        // A run's errors of constants count once: the mean of eight runs spreads by about 0.15.
        EXPECT_GT(full_nees, 0.65);
        EXPECT_LT(full_nees, 1.4);
        EXPECT_GT(lag_nees, 0.65);
        EXPECT_LT(lag_nees, 1.4);
    }
}

TEST(SmoothingFilter, StretchesLeaveNoSeam) {
    const ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    World world(parameters, 1);
    FixedIntervalSmoother one(testing::smallSkeleton(), world.suit, parameters, spool(), 1e6);
    FixedIntervalSmoother many(testing::smallSkeleton(), world.suit, parameters, spool(), 0.13);
    const Judged whole = judge(one, parameters, 5, 2), pieces = judge(many, parameters, 5, 2);
    EXPECT_EQ(largestDifference(whole, pieces), 0) << "each stretch is filtered again to the bit";
    EXPECT_EQ(whole.poses.front().time_ns, 0);
    EXPECT_GE(whole.poses.size(), 278u);
}

TEST(SmoothingFilter, ALagAsLongAsTheTakeIsTheWhole) {
    const ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    World world(parameters, 1);
    FixedIntervalSmoother full(testing::smallSkeleton(), world.suit, parameters, spool());
    FixedLagSmoother lag(testing::smallSkeleton(), world.suit, parameters, 10, 1);
    EXPECT_LT(largestDifference(judge(full, parameters, 3, 2), judge(lag, parameters, 3, 2)), 1e-12);
}

TEST(SmoothingFilter, APoseWaitsForTheLagAndNoLonger) {
    const ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    World world(parameters, 1);
    FixedLagSmoother lag(testing::smallSkeleton(), world.suit, parameters, 0.5, 0.1);
    lag.start(testing::smallSkeleton().zeroPose(), {}, nullptr);
    int64_t last_ns = -1;
    testing::play(world, lag, 2, [&](int64_t, double t) {
        lag.advanceTo(t + testing::kUntilSure_s);
        for (const TimedPose& pose : lag.takePoses()) {
            EXPECT_GT(pose.time_ns, last_ns);
            last_ns = pose.time_ns;
            EXPECT_LE(static_cast<double>(pose.time_ns) * 1e-9, t - 0.39);
        }
        if (t > 0.6) {
            EXPECT_GE(static_cast<double>(last_ns) * 1e-9, t - 0.51);
        }
    });
    EXPECT_GT(last_ns, 1'400'000'000);
}

TEST(SmoothingFilter, CancelledInAStretch) {
    const ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    World world(parameters, 1);
    FixedIntervalSmoother full(testing::smallSkeleton(), world.suit, parameters, spool());
    full.start(testing::smallSkeleton().zeroPose(), {}, nullptr);
    testing::play(world, full, 1, [&](int64_t, double t) { full.advanceTo(t); });
    CancelFlag flag;
    flag.cancel();
    const Status cancelled = full.finishPortion({nullptr, &flag});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(full.takePoses().empty());
}

}  // namespace
}  // namespace noctule
