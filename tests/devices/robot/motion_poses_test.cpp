// SPDX-License-Identifier: Apache-2.0
// A recorded motion leads a robot: it waits, plays, stays at its end or begins again without a jump.
#include "devices/robot/motion_poses.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule::robot_link {
namespace {

/// The right forearm turns by a radian in ten frames of a hundredth of a second.
TimedMotion tenFrames() {
    const Skeleton& skeleton = defaultActor().skeleton;
    const auto forearm = static_cast<size_t>(skeleton.find("RightForeArm"));
    TimedMotion motion{skeleton, {}};
    for (int i = 0; i < 10; ++i) {
        Pose pose = skeleton.zeroPose();
        pose.q_parent_joint[forearm] = axisAngle(Vector3d::UnitY(), i / 9.0);
        motion.frames.push_back({1'000'000'000 + i * 10'000'000, pose, {}});
    }
    return motion;
}

class MotionPosesTest : public ::testing::Test {
protected:
    static bool waitFor(const std::function<bool()>& is_so) {
        for (int i = 0; i < 4000 && !is_so(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return is_so();
    }
    int64_t count() const {
        const auto newest = feed_.newest();
        return newest ? newest->count : 0;
    }

    const robot::PerformerArms performer_ = *robot::PerformerArms::make(defaultActor().skeleton, "performer");
    PoseFeed feed_{defaultActor().skeleton, performer_};
};

TEST_F(MotionPosesTest, PausedItGivesItsFirstPoseAgainAndAgain) {
    MotionPoses poses(tenFrames(), feed_, MotionPoses::AtEnd::kEnds, false);
    ASSERT_TRUE(waitFor([&] { return count() > 5; }));
    EXPECT_EQ(poses.time_ns(), 1'000'000'000);
    EXPECT_FALSE(poses.ended());
    poses.setPlaying(true);
    ASSERT_TRUE(waitFor([&] { return poses.ended(); }));
    EXPECT_EQ(feed_.newest()->time_ns, 1'090'000'000) << "the last pose was given";
}

TEST_F(MotionPosesTest, ItStaysAtItsEndUntilItIsPlayedAgain) {
    MotionPoses poses(tenFrames(), feed_, MotionPoses::AtEnd::kStays, true);
    ASSERT_TRUE(waitFor([&] { return !poses.isPlaying(); }));
    const int64_t so_far = count();
    ASSERT_TRUE(waitFor([&] { return count() > so_far + 5; }));
    EXPECT_EQ(poses.time_ns(), 1'090'000'000);
    poses.setPlaying(true);
    EXPECT_TRUE(waitFor([&] { return poses.time_ns() < 1'050'000'000 || !poses.isPlaying(); }));
}

TEST_F(MotionPosesTest, RepeatedItGoesBackToItsBeginning) {
    MotionPoses poses(tenFrames(), feed_, MotionPoses::AtEnd::kRepeats, true);
    ASSERT_TRUE(waitFor([&] { return count() > 25; }));
    EXPECT_TRUE(poses.isPlaying());
    EXPECT_FALSE(poses.ended());
}

TEST(JoinedEndsTest, TheWayBackHasNoJump) {
    const TimedMotion joined = joinedEnds(tenFrames(), 1);
    ASSERT_EQ(joined.frames.size(), 109U) << "a second of a hundred frames, its ends are there already";
    const auto forearm = static_cast<size_t>(joined.skeleton.find("RightForeArm"));
    for (size_t i = 10; i <= joined.frames.size(); ++i) {
        const TimedPose& next = joined.frames[i % joined.frames.size()];
        const double step = angleBetween(joined.frames[i - 1].pose->q_parent_joint[forearm],
                                         next.pose->q_parent_joint[forearm]);
        EXPECT_LT(step, 0.019) << "1.875 rad/s at most" << i;
        if (i < joined.frames.size()) {
            EXPECT_EQ(next.time_ns - joined.frames[i - 1].time_ns, 10'000'000);
        }
    }
}

}  // namespace
}  // namespace noctule::robot_link
