// SPDX-License-Identifier: Apache-2.0
// Shifts between the clocks of two recordings: other gaits, rates, lengths and dialects, and refusals.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/motion/dialects.h"

namespace noctule::test {
namespace {

/// A walk of which every stride is as the one before; the left side lags half a stride.
TimedMotion treadmill(double from_s, double seconds, double frames_per_second, double stride_s) {
    TimedMotion motion{skeleton(), {}};
    const auto turn = [&](Pose& pose, const std::string& joint, const Vector3d& axis, double angle_rad) {
        pose.q_parent_joint[static_cast<size_t>(motion.skeleton.find(joint))] = axisAngle(axis, angle_rad);
    };
    for (int i = 0; i < seconds * frames_per_second; ++i) {
        const double phase = 2 * std::numbers::pi * (from_s + i / frames_per_second) / stride_s;
        Pose pose = motion.skeleton.zeroPose();
        for (const auto& [side, at] :
             {std::pair{"Left", phase}, std::pair{"Right", phase + std::numbers::pi}}) {
            turn(pose, std::string(side) + "UpLeg", Vector3d::UnitX(), 0.5 * std::sin(at));
            turn(pose, std::string(side) + "Leg", Vector3d::UnitX(), 0.4 + 0.4 * std::sin(at + 1));
            turn(pose, std::string(side) + "Arm", Vector3d::UnitZ(), 0.3 * std::sin(at));
        }
        motion.frames.push_back({std::llround(i * 1e9 / frames_per_second), pose, {}});
    }
    return motion;
}

double shiftMs(const TimeOffset& offset) {
    return static_cast<double>(offset.add_to_reference_ns) * 1e-6;
}

void expectShift(const TimedMotion& estimate, const TimedMotion& reference, double expected_ms) {
    const auto found = findTimeOffset(estimate, reference);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->trusted()) << distrust(*found);
    EXPECT_NEAR(shiftMs(*found), expected_ms, 20);
    EXPECT_NEAR(shiftMs(*found), expected_ms, 5 * static_cast<double>(found->sigma_ns) * 1e-6 + 2);
}

TEST(TimeOffset, OtherShiftsRatesAndLengths) {
    const TimedMotion take = lively(0, 30, 140);
    expectShift(take, lively(3, 27, 120), 3000);
    expectShift(take, lively(7.3, 6, 20), 7300);          // shorter, at 20 Hz
    expectShift(take, lively(-4.5, 20, 30), -4500);       // began before the take
    expectShift(take, lively(12.345, 40, 59.94), 12345);  // lasts longer than the take
    expectShift(take, lively(22, 5, 240), 22000);
}

TEST(TimeOffset, DialectsOfTheReferenceHaveNoEffect) {
    const TimedMotion take = lively(0, 20, 140);
    const TimedMotion reference = lively(3, 12, 60);
    expectShift(take, inDialect(reference, aPose(), false, {}), 3000);
    expectShift(take, inDialect(reference, {}, true, xsensNames()), 3000);
}

TEST(TimeOffset, AMirroredHalfStepDoesNotWin) {
    // A rest, then strides without any difference: whole strides are as good, half strides are not.
    const TimedMotion take = treadmill(0, 12, 100, 1.24);
    const auto found = findTimeOffset(take, treadmill(3, 6, 50, 1.24));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->trusted());
    const double strides = (shiftMs(*found) - 3000) / 1240;
    EXPECT_NEAR(strides, std::round(strides), 0.03);
    for (const TimeOffset::Rival& rival : found->rivals) {
        const double of_rival = (static_cast<double>(rival.add_to_reference_ns) * 1e-6 - 3000) / 1240;
        EXPECT_NEAR(of_rival, std::round(of_rival), 0.03);
    }
}

TEST(TimeOffset, ARepeatedMotionIsSaidToRepeatItself) {
    for (const double stride_s : {0.7, 1.1, 2.5}) {
        const auto found = findTimeOffset(treadmill(0, 15, 100, stride_s), treadmill(4, 8, 60, stride_s));
        ASSERT_TRUE(found);
        EXPECT_FALSE(found->trusted());
        EXPECT_NE(distrust(*found).find("repeats itself"), std::string::npos) << distrust(*found);
    }
}

TEST(TimeOffset, ARestBeforeTheStridesDoesNotChangeThat) {
    TimedMotion take = treadmill(0, 6, 100, 1.1);
    for (TimedPose& frame : take.frames)
        frame.time_ns += 3 * kSecond_ns;
    take.frames.insert(take.frames.begin(), {0, take.frames[0].pose, {}});
    const auto found = findTimeOffset(take, treadmill(0, 6, 60, 1.1));
    ASSERT_TRUE(found);
    EXPECT_TRUE(!found->trusted() || std::abs(shiftMs(*found) - 3000) < 20) << shiftMs(*found);
}

TEST(TimeOffset, AnotherMotionIsRefused) {
    const auto found = findTimeOffset(lively(0, 20, 100), swinging(skeleton(), 15, 60));
    EXPECT_TRUE(!found || !found->trusted());
}

TEST(TimeOffset, StandingStillCannotBeAligned) {
    TimedMotion standing{skeleton(), {}};
    for (int i = 0; i < 2000; ++i) {
        Pose pose = skeleton().zeroPose();
        const double sway = 0.01 * std::sin(0.02 * i);
        pose.q_parent_joint[0] = axisAngle(Vector3d::UnitX(), sway);
        standing.frames.push_back({i * 10'000'000LL, pose, {}});
    }
    const auto found = findTimeOffset(standing, standing);
    EXPECT_TRUE(!found || !found->trusted());
}

/// As estimates err: each joint by slow errors of its own and a lag of its own, 12 ms rms. `late`: the motion
/// later by -24, -18, ... 24 ms.
TimedMotion asEstimated(const std::vector<TimedMotion>& late, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const int middle = static_cast<int>(late.size() / 2);
    TimedMotion motion = late[static_cast<size_t>(middle)];
    for (size_t j = 1; j < motion.skeleton.joints().size(); ++j) {
        const int steps = std::clamp(static_cast<int>(std::lround(2 * normal(random))), -middle, middle);
        const TimedMotion& lagging = late[static_cast<size_t>(middle + steps)];
        const Vector3d axis = Vector3d{normal(random), normal(random), normal(random)}.normalized();
        const double size = 0.06 * std::abs(normal(random)), rate = 2 + 3 * std::abs(normal(random)),
                     phase = 6 * normal(random);
        if (motion.skeleton.joint(static_cast<int>(j)).type == JointType::kFixed)
            continue;
        for (size_t f = 0; f < motion.frames.size(); ++f) {
            const double t_s = static_cast<double>(motion.frames[f].time_ns) * 1e-9;
            motion.frames[f].pose->q_parent_joint[j] = lagging.frames[f].pose->q_parent_joint[j] *
                                                       axisAngle(axis, size * std::sin(rate * t_s + phase));
        }
    }
    return motion;
}

TEST(TimeOffset, TheStatedUncertaintyIsThatOfTwentyCases) {
    std::vector<TimedMotion> late;
    for (int step = -4; step <= 4; ++step)
        late.push_back(lively(-0.006 * step, 14, 100));
    double squares = 0;
    int beyond_three = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const double start_s = 1 + 0.3 * seed, seconds = 4 + 0.15 * seed;
        const auto found = findTimeOffset(asEstimated(late, seed), lively(start_s, seconds, 50));
        ASSERT_TRUE(found);
        const double z = (shiftMs(*found) - 1000 * start_s) / (static_cast<double>(found->sigma_ns) * 1e-6);
        squares += z * z;
        beyond_three += std::abs(z) > 3;
        EXPECT_GT(found->sigma_ns, 300'000) << seed;
    }
    const double rms = std::sqrt(squares / 20);
    std::printf("errors are %.2f times what is stated\n", rms);
    EXPECT_LT(rms, 1.5) << "too sure";
    EXPECT_GT(rms, 0.4) << "too modest";
    EXPECT_LE(beyond_three, 1);
}

}  // namespace
}  // namespace noctule::test
