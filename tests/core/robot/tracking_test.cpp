// SPDX-License-Identifier: Apache-2.0
// A path that comes later and smaller is found to be just that.
#include "core/robot/tracking.h"

#include <gtest/gtest.h>

namespace noctule::robot {
namespace {

/// A figure of eight, once in two seconds, 140 times a second.
std::vector<PathPoint> eight(double seconds, double delay_s, double scale, double rate_hz = 140) {
    std::vector<PathPoint> path;
    for (int i = 0; i < seconds * rate_hz; ++i) {
        const double time_s = i / rate_hz, t = std::numbers::pi * (time_s - delay_s);
        path.push_back({time_s, scale * Vector3d(0.2 * std::sin(t), 0.1 * std::sin(2 * t), 0)});
    }
    return path;
}

TEST(TrackingTest, ADelayIsFoundAndNothingRemains) {
    for (const double delay_s : {0.0, 0.0371, 0.096, 0.31}) {
        const auto tracking = trackingOf(eight(6, 0, 1), eight(6, delay_s, 1, 125));
        ASSERT_TRUE(tracking);
        EXPECT_NEAR(tracking->delay_s, delay_s, 0.0006);
        EXPECT_LT(tracking->rest_rms_m, 0.0003) << "straight lines between commands";
        EXPECT_EQ(tracking->points, 687) << "of 750: 63 in the first half second are left out";
    }
}

TEST(TrackingTest, WhatTheDelayDoesNotExplainRemains) {
    const auto tracking = trackingOf(eight(6.5, 0, 1), eight(6.5, 0.1, 0.9));
    ASSERT_TRUE(tracking);
    EXPECT_NEAR(tracking->delay_s, 0.1, 0.001);
    // A tenth of the way from the middle: sqrt(0.2^2 / 2 + 0.1^2 / 2) / 10 over whole turns.
    EXPECT_NEAR(tracking->rest_rms_m, 0.0158, 0.0005);
    EXPECT_GT(tracking->rest_max_m, tracking->rest_rms_m);
    EXPECT_GT(tracking->apart_rms_m, 2 * tracking->rest_rms_m);
}

TEST(TrackingTest, NothingIsSaidOfARobotThatIsNotMovedOrNotSeen) {
    EXPECT_FALSE(trackingOf(eight(6, 0, 0.01), eight(6, 0.1, 0.01)));
    EXPECT_FALSE(trackingOf(eight(6, 0, 1), {}));
    EXPECT_FALSE(trackingOf({}, eight(6, 0, 1)));
    EXPECT_FALSE(trackingOf(eight(6, 0, 1), eight(0.53, 0.1, 1))) << "all within the longest delay";
}

}  // namespace
}  // namespace noctule::robot
