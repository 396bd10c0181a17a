// SPDX-License-Identifier: Apache-2.0
#include "core/motion/foot_contacts.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kRate_hz = 120;
constexpr double kStride_s = 1.0, kStance_s = 0.6;

/// A leg whose foot is wherever the root is: joints without offsets, so that one foot's course is exact.
Skeleton oneFoot() {
    const auto skeleton =
        Skeleton::make({{"Hips", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}},
                        {"LeftFoot", 0, Vector3d::Zero(), JointType::kFixed, {}, Vector3d(0, 0, 0.15), {}}});
    return *skeleton;
}

/// Stands kStance_s of every stride, then flies 0.7 m forward and 0.15 m up.
Vector3d walkingFoot(double t_s, double slide_m_per_s) {
    const double stride = std::floor(t_s / kStride_s), phase_s = t_s - stride * kStride_s;
    const double slid_m = slide_m_per_s * std::min(phase_s, kStance_s);
    if (phase_s <= kStance_s)
        return {slid_m, 0.08, 0.7 * stride};
    const double swing = (phase_s - kStance_s) / (kStride_s - kStance_s);
    const double smooth = swing * swing * (3 - 2 * swing);
    return {slid_m * (1 - smooth), 0.08 + 0.15 * std::sin(std::numbers::pi * swing), 0.7 * (stride + smooth)};
}

TimedMotion walk(double seconds, double slide_m_per_s = 0) {
    TimedMotion motion{oneFoot(), {}};
    for (int i = 0; i < seconds * kRate_hz; ++i) {
        Pose pose = motion.skeleton.zeroPose();
        pose.p_world_root = walkingFoot(i / kRate_hz, slide_m_per_s);
        motion.frames.push_back({std::llround(i * 1e9 / kRate_hz), pose, {}});
    }
    return motion;
}

TEST(FootContacts, FindsEveryStanceOfAWalk) {
    const auto feet = findFootContacts(walk(6));
    ASSERT_EQ(feet.size(), 1u);
    EXPECT_EQ(feet[0].foot, "LeftFoot");
    ASSERT_EQ(feet[0].contacts.size(), 6u);
    for (size_t i = 0; i < 6; ++i) {
        const FootContact& contact = feet[0].contacts[i];
        EXPECT_NEAR(contact.from_s, static_cast<double>(i) * kStride_s, 0.06);
        EXPECT_NEAR(contact.to_s, static_cast<double>(i) * kStride_s + kStance_s, 0.06);
        EXPECT_LT(contact.slide_m, 0.01);
    }
}

TEST(FootContacts, MeasuresTheSlide) {
    const auto feet =
        findFootContacts(walk(6, 0.1));  // 36 mm in the middle of a stance: 18 mm to either side
    ASSERT_EQ(feet.size(), 1u);
    EXPECT_EQ(feet[0].contacts.size(), 6u);
    EXPECT_NEAR(meanSlide_m(feet), 0.018, 0.003);
}

TEST(FootContacts, IsIndependentOfTheHeightOfTheFloor) {
    TimedMotion motion = walk(4);
    for (TimedPose& frame : motion.frames)
        frame.pose->p_world_root.y() -= 3;
    EXPECT_EQ(findFootContacts(motion)[0].contacts.size(), findFootContacts(walk(4))[0].contacts.size());
}

TEST(FootContacts, FollowARootThatDrifts) {
    TimedMotion motion = walk(30);
    for (TimedPose& frame : motion.frames)
        frame.pose->p_world_root += static_cast<double>(frame.time_ns) * 1e-9 * Vector3d(0.08, -0.03, 0.05);
    EXPECT_EQ(findFootContacts(motion)[0].contacts.size(), 30u);
}

TEST(FootContacts, AHoleEndsAContactAndAFlickerDoesNot) {
    TimedMotion motion = walk(1);
    for (size_t i = 30; i < 36; ++i)
        motion.frames[i].pose.reset();
    EXPECT_EQ(findFootContacts(motion)[0].contacts.size(), 2u);
    motion = walk(1);
    motion.frames[30].pose->p_world_root.y() += 0.2;  // no foot flies for a frame
    EXPECT_EQ(findFootContacts(motion)[0].contacts.size(), 1u);
}

TEST(FootContacts, NothingToSeeIsNoContact) {
    EXPECT_TRUE(findFootContacts(TimedMotion{}).empty());
    TimedMotion unseen{oneFoot(), {{0, std::nullopt, {}}, {1'000'000, std::nullopt, {}}}};
    EXPECT_TRUE(findFootContacts(unseen)[0].contacts.empty());
    EXPECT_EQ(meanSlide_m(findFootContacts(unseen)), 0);
    unseen.frames.resize(1);
    EXPECT_TRUE(findFootContacts(unseen)[0].contacts.empty());
}

TEST(FootContacts, StandingStillIsOneContactOfBothFeet) {
    const Actor actor = defaultActor();
    TimedMotion motion{actor.skeleton, {}};
    for (int i = 0; i < 120; ++i)
        motion.frames.push_back({std::llround(i * 1e9 / kRate_hz), actor.restPose(), {}});
    const auto feet = findFootContacts(motion);
    ASSERT_EQ(feet.size(), 2u);
    EXPECT_EQ(feet[0].foot, "LeftFoot");
    EXPECT_EQ(feet[1].foot, "RightFoot");
    for (const FootContacts& foot : feet) {
        ASSERT_EQ(foot.contacts.size(), 1u);
        EXPECT_NEAR(foot.contacts[0].to_s, 119 / kRate_hz, 1e-6);
        EXPECT_LT(foot.contacts[0].slide_m, 1e-9);
    }
}

}  // namespace
}  // namespace noctule
