// SPDX-License-Identifier: Apache-2.0
#include "core/guide/movement_guide.h"

#include <gtest/gtest.h>

#include "tests/core/guide/rig_health.h"

namespace noctule {
namespace {

constexpr double kBrisk_rad_per_s = 0.6;

class MovementGuideTest : public testing::Test {
protected:
    MovementGuideTest() : guide_(suit_, nominalCalibration(suit_), test::kRigRate_hz), health_(suit_) {}

    static Suit wornSuit() {
        Suit suit = test::rigSuit(4);
        const char* const segments[] = {"Hips", "LeftForeArm", "LeftUpLeg", "LeftLeg"};
        for (size_t board = 0; board < suit.boards.size(); ++board)
            suit.boards[board].segment = segments[board];
        return suit;
    }
    void shake(size_t board, double rad_per_s) {
        health_.board(board).means->gyro_deviation_rad_per_s = rad_per_s;
    }
    /// All boards alike; the last guidance.
    const Guidance& go(double seconds, double rad_per_s) {
        for (size_t board = 0; board < suit_.boards.size(); ++board)
            shake(board, rad_per_s);
        return wait(seconds);
    }
    const Guidance& wait(double seconds) {
        for (double waited_s = 0; waited_s < seconds - 0.05; waited_s += 0.1)
            guide_.look(health_.after(0.1));
        return guide_.guidance();
    }

    Suit suit_ = wornSuit();
    MovementGuide guide_;
    test::RigHealth health_;
};

TEST_F(MovementGuideTest, EachExerciseBeginsInTheRestPoseAndIsTakenWhenItHasLasted) {
    for (int step = 0; step < kExerciseCount; ++step) {
        EXPECT_EQ(go(1, 0.02).hindrance, Hindrance::kStand);
        EXPECT_NEAR(guide_.guidance().value, 1.1, 0.01);
        EXPECT_EQ(go(1.5, 0.02).hindrance, Hindrance::kMove);
        EXPECT_TRUE(go(7, kBrisk_rad_per_s).isRight());
        EXPECT_EQ(guide_.guidance().step, step);
        EXPECT_NEAR(guide_.guidance().held_s, 6.9, 0.01);
        EXPECT_TRUE(go(0.6, kBrisk_rad_per_s).held_s >= MovementGuide::kMove_s);
        guide_.take();
    }
    EXPECT_TRUE(guide_.isFinished());
}

TEST_F(MovementGuideTest, WhoMovesBeforeTheRestPoseWasHeldIsToldWhatMoves) {
    go(1, 0.02);
    shake(1, kBrisk_rad_per_s);
    EXPECT_EQ(wait(0.5).hindrance, Hindrance::kMoves);
    EXPECT_EQ(guide_.guidance().board, 1);
    EXPECT_EQ(go(1, 0.02).hindrance, Hindrance::kStand) << "the count begins again";
}

TEST_F(MovementGuideTest, AMovementThatStopsIsBegunAgain) {
    go(2.5, 0.02);
    EXPECT_TRUE(go(4, kBrisk_rad_per_s).isRight());
    EXPECT_EQ(go(0.5, 0.02).hindrance, Hindrance::kStand);
    EXPECT_EQ(guide_.guidance().held_s, 0);
    EXPECT_FALSE(guide_.isMoving());
}

TEST_F(MovementGuideTest, ABoardThatTheExerciseAsksForAndThatHardlyMovedIsNamed) {
    go(2.5, 0.02);
    go(1, kBrisk_rad_per_s);  // squats: forearm, thigh and shin
    EXPECT_TRUE(guide_.guidance().isRight());
    go(2.5, 0.02);  // stopped, stands again
    for (const size_t board : {0, 2, 3})
        shake(board, kBrisk_rad_per_s);
    EXPECT_EQ(wait(7.5).hindrance, Hindrance::kIdle);
    EXPECT_EQ(guide_.guidance().board, 1);
    EXPECT_EQ(guide_.guidance().hindering, 1);
    EXPECT_EQ(guide_.guidance().boards[1], GuidedBoard::kIdle);
    EXPECT_EQ(guide_.guidance().held_s, 0) << "and is not taken";
    EXPECT_EQ(go(1, 0.02).hindrance, Hindrance::kIdle) << "said until the next movement begins";
    go(1.5, 0.02);
    EXPECT_TRUE(go(7.6, kBrisk_rad_per_s).held_s >= MovementGuide::kMove_s);
}

TEST_F(MovementGuideTest, ASilentBoardStopsTheExerciseUnlessItIsSkipped) {
    go(2.5, 0.02);
    go(3, kBrisk_rad_per_s);
    health_.board(2).silent = true;
    EXPECT_EQ(wait(0.1).hindrance, Hindrance::kAbsent);
    EXPECT_EQ(guide_.guidance().board, 2);
    guide_.skip(2, true);
    EXPECT_EQ(go(1, 0.02).hindrance, Hindrance::kStand);
    go(1.5, 0.02);
    EXPECT_TRUE(go(7.6, kBrisk_rad_per_s).held_s >= MovementGuide::kMove_s);
}

TEST(Exercises, BeginAndEndInTheRestPoseAndTurnEveryJointThatTheyAskFor) {
    const Actor actor = defaultActor();
    const Pose rest = actor.restPose();
    for (int number = 0; number < kExerciseCount; ++number) {
        const auto exercise = static_cast<Exercise>(number);
        const Pose begin = exercisePose(actor, exercise, 0, 8), end = exercisePose(actor, exercise, 8, 8);
        for (int j = 0; j < actor.skeleton.size(); ++j) {
            const auto joint = static_cast<size_t>(j);
            EXPECT_LT(rest.q_parent_joint[joint].angularDistance(begin.q_parent_joint[joint]), 1e-6);
            EXPECT_LT(rest.q_parent_joint[joint].angularDistance(end.q_parent_joint[joint]), 1e-6);
            double largest_rad = 0;
            for (double t_s = 0; t_s < 8; t_s += 0.1)
                largest_rad =
                    std::max(largest_rad, rest.q_parent_joint[joint].angularDistance(
                                              exercisePose(actor, exercise, t_s, 8).q_parent_joint[joint]));
            if (asksFor(exercise, actor.skeleton.joint(j).name)) {
                EXPECT_GT(largest_rad, 0.15) << number << " " << actor.skeleton.joint(j).name;
            }
        }
    }
}

}  // namespace
}  // namespace noctule
