// SPDX-License-Identifier: Apache-2.0
#include "core/robot/step_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/robot/inverse_kinematics.h"

namespace noctule::robot {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Largest part of each limit over a walk after random wishes.
struct Used {
    double place = 0, speed = 0, acceleration = 0, jerk = 0;
};

Used walk(const JointLimits& limits, double dt_s, uint64_t seed, int steps) {
    const StepLimiter limiter(limits, dt_s);
    RandomPostures random(seed);
    JointMotion now;
    Used used;
    double wish = 0, speed = 0;
    for (int i = 0; i < steps; ++i) {
        if (random.uniform() < 0.03)
            wish = 4 * random.uniform() - 2;  // often beyond the place's limits
        if (random.uniform() < 0.05)
            speed = 6 * random.uniform() - 3;
        wish += speed * dt_s * (random.uniform() < 0.5);
        const JointMotion next = limiter.after(now, limiter.approach(now, wish, speed));
        const double middle = (limits.lower + limits.upper) / 2;
        used.place = std::max(used.place, std::abs(next.place - middle) / (limits.upper - middle));
        used.speed = std::max(used.speed, std::abs(next.speed) / limits.speed);
        used.acceleration = std::max(used.acceleration, std::abs(next.acceleration) / limits.acceleration);
        used.jerk = std::max(used.jerk, std::abs(next.acceleration - now.acceleration) / dt_s / limits.jerk);
        now = next;
    }
    return used;
}

TEST(StepLimiter, KeepsEveryLimitWhateverIsWished) {
    const JointLimits all[] = {
        {-1, 1, 2, 20, 400},      {-1, 1, 2, 20, 4000},           {-1, 1, 0.5, 3, 30},
        {-1, 1, 2, 20, kEndless}, {-1, 1, 2, kEndless, kEndless}, {-0.2, 0.2, 5, 50, 1000}};
    for (const JointLimits& limits : all)
        for (const double dt_s : {1.0 / 30, 0.01, 1.0 / 140})
            for (uint64_t seed = 1; seed <= 3; ++seed) {
                const Used used = walk(limits, dt_s, seed, 4000);
                SCOPED_TRACE(::testing::Message() << "jerk " << limits.jerk << ", acceleration "
                                                  << limits.acceleration << ", step " << dt_s);
                EXPECT_LT(used.place, 1 + 1e-9);
                EXPECT_LT(used.speed, 1 + 1e-9);
                EXPECT_LT(used.acceleration, 1 + 1e-6);  // 0 of an endless limit
                EXPECT_LT(used.jerk, 1 + 1e-6);
            }
}

TEST(StepLimiter, ArrivesWithoutOvershootAndStaysThere) {
    const JointLimits limits{-3, 3, 2, 20, 400};
    const StepLimiter limiter(limits, 0.01);
    JointMotion now;
    double farthest = 0;
    for (int i = 0; i < 300; ++i) {
        now = limiter.after(now, limiter.approach(now, 1, 0));
        farthest = std::max(farthest, now.place);
    }
    EXPECT_NEAR(now.place, 1, 1e-3);
    EXPECT_LT(farthest, 1 + 2e-3);
    // 1 rad at 2 rad/s, 0.1 s to reach 20 rad/s^2: at least 0.65 s, and not much more.
    JointMotion at;
    int steps = 0;
    for (; steps < 300 && at.place < 0.99; ++steps)
        at = limiter.after(at, limiter.approach(at, 1, 0));
    EXPECT_GT(steps, 55);
    EXPECT_LT(steps, 85);
}

TEST(StepLimiter, FollowsASlowWishExactly) {
    const StepLimiter limiter({-3, 3, 5, 50, 2000}, 0.01);
    JointMotion now;
    double before = 0, worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const double wish = 0.5 * (1 - std::cos(2 * i * 0.01));
        now = limiter.after(now, limiter.approach(now, wish, (wish - before) / 0.01));
        before = wish;
        worst = std::max(worst, std::abs(now.place - wish));
    }
    EXPECT_LT(worst, 1e-3);
}

// Integrates the stop that the formula promises.
TEST(StepLimiter, StoppingDistanceIsThatOfTheManoeuvre) {
    const JointLimits limits{-10, 10, 5, 20, 400};
    for (const double speed : {0.1, 0.8, 3.0})
        for (const double acceleration : {-20.0, -5.0, 0.0, 8.0}) {
            double v = speed, a = acceleration, x = 0, farthest = 0;
            constexpr double kStep_s = 1e-5;
            for (int i = 0; i < 200000 && v > 0; ++i) {
                // Brake harder while what is left to shed needs it, then ease.
                const bool ease = a < 0 && v <= a * a / (2 * limits.jerk);
                a = ease ? a + limits.jerk * kStep_s
                         : std::max(-limits.acceleration, a - limits.jerk * kStep_s);
                a = std::min(a, speed > 0 ? 20.0 : a);
                v += a * kStep_s;
                x += v * kStep_s;
                farthest = std::max(farthest, x);
            }
            EXPECT_NEAR(stoppingDistance(speed, acceleration, limits), farthest, 2e-3 * (1 + farthest))
                << speed << " " << acceleration;
        }
}

}  // namespace
}  // namespace noctule::robot
