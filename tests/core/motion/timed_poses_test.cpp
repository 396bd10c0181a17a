// SPDX-License-Identifier: Apache-2.0
#include "core/motion/timed_poses.h"

#include <gtest/gtest.h>

#include "core/motion/joint_angles.h"
#include "core/motion/time_offset.h"
#include "tests/core/motion/made_motion.h"

namespace noctule {
namespace {

using namespace test;

double distance_rad(const Pose& a, const Pose& b) {
    double most = 0;
    for (size_t j = 0; j < a.q_parent_joint.size(); ++j)
        most = std::max(most, angleBetween(a.q_parent_joint[j], b.q_parent_joint[j]));
    return most;
}

TEST(TimedPoses, ResamplingFollowsTheMotionAtEveryRate) {
    const TimedMotion motion = swinging(skeleton(), 2, 140);
    for (const double rate : {24.0, 30.0, 120.0, 500.0}) {
        const TimedMotion other = resample(motion, rate);
        EXPECT_EQ(other.frames.size(), static_cast<size_t>(std::floor((2 - 1.0 / 140) * rate)) + 1);
        for (const TimedPose& frame : other.frames) {
            const double t_s = static_cast<double>(frame.time_ns) * 1e-9;
            ASSERT_LT(distance_rad(*frame.pose, swingingPose(skeleton(), t_s)), 1e-4);
        }
    }
}

TEST(TimedPoses, ClipStartsAtTheFirstSeenFrameAndBridgesHoles) {
    TimedMotion motion = swinging(skeleton(), 2, 100);
    for (size_t i : {0u, 1u, 2u, 100u, 101u, 199u})
        motion.frames[i].pose.reset();
    const MotionClip clip = toClip("walk", motion, 50);
    EXPECT_EQ(clip.name, "walk");
    EXPECT_EQ(clip.frames.size(), 98u);  // 0.03 s to 1.98 s
    EXPECT_DOUBLE_EQ(clip.frame_time_s, 0.02);
    EXPECT_LT(distance_rad(clip.frames[0], swingingPose(skeleton(), 0.03)), 1e-9);
    EXPECT_TRUE(toClip("nothing", {skeleton(), {}}, 50).frames.empty());
}

TEST(TimedPoses, SamplerGoesBackAsWellAsForth) {
    const TimedMotion motion = swinging(skeleton(), 1, 100);
    PoseSampler sampler(motion, kSecond_ns);
    const auto late = sampler.at(905'000'000);
    const auto early = sampler.at(105'000'000);
    ASSERT_TRUE(late && early);
    EXPECT_LT(distance_rad(*early, swingingPose(skeleton(), 0.105)), 1e-4);
    EXPECT_FALSE(sampler.at(-1));
    EXPECT_FALSE(sampler.at(2 * kSecond_ns));
    EXPECT_TRUE(sampler.at(990'000'000));
}

TEST(JointAngles, ComposeBackToTheRotationAndStayNear) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-1.5, 1.5);
    for (int i = 0; i < 200; ++i) {
        const Vector3d zxy{2 * angle(random), angle(random), 2 * angle(random)};
        const Quaterniond q = axisAngle(Vector3d::UnitZ(), zxy[0]) * axisAngle(Vector3d::UnitX(), zxy[1]) *
                              axisAngle(Vector3d::UnitY(), zxy[2]);
        ASSERT_LT((anglesZxy(q) - zxy).norm(), 1e-9);
        const Vector3d turned = zxy + Vector3d(2 * std::numbers::pi, 0, -4 * std::numbers::pi);
        ASSERT_LT((anglesZxyNear(q, turned) - turned).norm(), 1e-9);
        const Vector3d beyond(zxy[0] + std::numbers::pi, std::numbers::pi - zxy[1],
                              zxy[2] + std::numbers::pi);
        ASSERT_LT((anglesZxyNear(q, beyond) - beyond).norm(), 1e-9);
    }
}

TEST(JointAngles, SigmaAgreesWithDifferences) {
    const Vector3d zxy(0.4, -0.7, 1.1), sigma(0.01, 0.02, 0.03);
    const auto rotation = [](const Vector3d& a) {
        return axisAngle(Vector3d::UnitZ(), a[0]) * axisAngle(Vector3d::UnitX(), a[1]) *
               axisAngle(Vector3d::UnitY(), a[2]);
    };
    Vector3d variance = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector3d step = 1e-6 * Vector3d::Unit(k);
        const Vector3d change = (anglesZxy(rotation(zxy) * expQuaternion(step)) -
                                 anglesZxy(rotation(zxy) * expQuaternion(-step))) /
                                2e-6;
        variance += (change * sigma[k]).cwiseAbs2();
    }
    EXPECT_LT((sigmaZxy(zxy, sigma) - variance.cwiseSqrt()).norm(), 1e-8);
    EXPECT_DOUBLE_EQ(sigmaZxy({0, std::numbers::pi / 2, 0}, sigma)[0], std::numbers::pi);
}

TEST(TimeOffset, IsFoundBelowTheFrameWhateverTheRates) {
    const TimedMotion estimate = swinging(skeleton(), 20, 140);
    for (const double late_s : {-3.3333, -0.0041, 0.0, 0.25, 4.0067}) {
        const auto found = findTimeOffset(estimate, swinging(skeleton(), 20, 60, late_s));
        ASSERT_TRUE(found);
        EXPECT_NEAR(static_cast<double>(found->add_to_reference_ns) * 1e-9, -late_s, 0.001) << late_s;
        EXPECT_TRUE(found->trusted());
    }
}

TEST(TimeOffset, ClocksMayStartFarApart) {
    const TimedMotion estimate = swinging(skeleton(), 10, 140);
    TimedMotion reference = estimate;
    for (TimedPose& frame : reference.frames)
        frame.time_ns += 7'123'000'000;
    EXPECT_NEAR(static_cast<double>(findTimeOffset(estimate, reference)->add_to_reference_ns) * 1e-9, -7.123,
                0.001);
}

TEST(TimeOffset, StillnessAndShortnessGiveNothing) {
    TimedMotion still = swinging(skeleton(), 5, 100);
    for (TimedPose& frame : still.frames)
        frame.pose = skeleton().zeroPose();
    EXPECT_FALSE(findTimeOffset(still, still));
    const TimedMotion brief = swinging(skeleton(), 1, 100);
    EXPECT_FALSE(findTimeOffset(brief, brief));
    EXPECT_FALSE(findTimeOffset({skeleton(), {}}, brief));
}

TEST(PoseSource, IsGoneThroughAnewUntilItsReaderHasEnough) {
    const TimedMotion motion = swinging(skeleton(), 1, 60, 0);
    const PoseSource source = sourceOf(motion);
    for (const size_t wanted : {size_t{3}, motion.frames.size()}) {
        std::vector<int64_t> times_ns;
        EXPECT_TRUE(source.forEach([&](TimedPose&& frame) {
            times_ns.push_back(frame.time_ns);
            return times_ns.size() < wanted;
        }));
        ASSERT_EQ(times_ns.size(), wanted);
        EXPECT_EQ(times_ns[2], motion.frames[2].time_ns);
    }
    EXPECT_EQ(source.all()->frames.size(), motion.frames.size());
    EXPECT_EQ(source.seen().value()->first_ns, motion.frames.front().time_ns);
    EXPECT_EQ(source.seen().value()->last_ns, motion.frames.back().time_ns);
    const TimedMotion nothing{motion.skeleton, {}};
    EXPECT_FALSE(sourceOf(nothing).seen().value());
}

}  // namespace
}  // namespace noctule
