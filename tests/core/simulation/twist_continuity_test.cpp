// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/twist_continuity.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"

namespace noctule::simulation {
namespace {

TEST(TwistContinuity, TakesHalfTurnsOffAndLeavesMotionAlone) {
    const Vector3d bone = -Vector3d::UnitY();
    const double dt = 1.0 / 120;
    TwistContinuity twist(bone, dt);
    double worst = 0;
    for (int f = 0; f < 600; ++f) {
        // A limb that swings at 6 rad/s and truly twists by 4 rad/s at most; seen flipped in the middle.
        const Quaterniond truth =
            axisAngle(Vector3d::UnitX(), std::sin(f * dt * 6)) * axisAngle(bone, std::sin(f * dt * 4));
        const bool flipped = f > 200 && f < 300;
        const Quaterniond kept = twist.next(flipped ? truth * axisAngle(bone, std::numbers::pi) : truth);
        worst = std::max(worst, angleBetween(kept, truth));
    }
    EXPECT_EQ(twist.jumps(), 2);
    EXPECT_LT(worst,
              0.08);  // what the motion itself twists in a frame is taken off with the jump, then fades
}

TEST(TwistContinuity, FastButPossibleTwistPasses) {
    const Vector3d bone = Vector3d::UnitX();
    TwistContinuity twist(bone, 1.0 / 120);
    for (int f = 0; f < 240; ++f) {
        const Quaterniond truth = axisAngle(bone, std::sin(f / 120.0 * 20) * 1.5);  // 30 rad/s
        EXPECT_LT(angleBetween(twist.next(truth), truth), 1e-9);
    }
    EXPECT_EQ(twist.jumps(), 0);
}

}  // namespace
}  // namespace noctule::simulation
