// SPDX-License-Identifier: Apache-2.0
#include "core/guide/side_guide.h"

#include <gtest/gtest.h>

#include "tests/core/guide/rig_health.h"

namespace noctule {
namespace {

using test::RigHealth;

class SideGuideTest : public testing::Test {
protected:
    SideGuideTest() : guide_(suit_, nominalCalibration(suit_), test::kRigRate_hz), rig_(suit_) {}
    void takeSide(BoardSide side) {
        rig_.lay(side);
        guide_.look(rig_.after(0.1));
        guide_.take();
    }

    Suit suit_ = test::rigSuit(18);
    SideGuide guide_;
    RigHealth rig_;
};

TEST_F(SideGuideTest, KnowsAllSidesOfBoardsThatWereNeverCalibrated) {
    for (size_t side = 0; side < kBoardSides.size(); ++side) {
        rig_.lay(kBoardSides[side]);
        const Guidance& now = guide_.look(rig_.after(0.1));
        EXPECT_TRUE(now.isRight()) << side;
        EXPECT_EQ(now.step, static_cast<int>(side));
        guide_.take();
        EXPECT_EQ(guide_.look(rig_.after(0.1)).hindrance, Hindrance::kDone);
    }
    EXPECT_TRUE(guide_.isFinished());
}

/// A zero of 1.5 g is within what chips may have: once a side was taken the opposite one tells it.
TEST_F(SideGuideTest, TakesABoardWithALargeZeroAndNamesOneThatLiesElsewhere) {
    const Vector3d zero(15, -15, 0);
    const auto lay = [&](BoardSide side, BoardSide of_board) {
        rig_.lay(side);
        rig_.set(9, Vector3d(kStandardGravity_m_per_s2 * of_board.up() + zero), Vector3d::Zero());
        return guide_.look(rig_.after(0.1)).boards[9];
    };
    for (const BoardSide side : {BoardSide{0, +1}, BoardSide{0, -1}, BoardSide{1, -1}, BoardSide{1, +1}}) {
        EXPECT_EQ(lay(side, side), GuidedBoard::kRight) << side.name();
        EXPECT_EQ(guide_.look(rig_.after(0.1)).right_boards, 18) << side.name();
        guide_.take();
    }
    EXPECT_EQ(lay({2, +1}, {0, +1}), GuidedBoard::kElsewhere);
}

TEST_F(SideGuideTest, NothingIsRightOfASuitThatIsGoneAndTheCountBeginsAnew) {
    guide_.look(rig_.after(0.1));
    ASSERT_GT(guide_.look(rig_.after(2.5)).held_s, 2);
    guide_.lose();
    EXPECT_FALSE(guide_.guidance().isRight());
    EXPECT_EQ(guide_.guidance().right_boards, 0);
    EXPECT_TRUE(guide_.guidance().boards.empty());
    EXPECT_EQ(guide_.look(rig_.after(10)).held_s, 0);
}

TEST_F(SideGuideTest, CountsHowLongASideHasBeenRightWithoutABreak) {
    guide_.look(rig_.after(0.1));
    EXPECT_NEAR(guide_.look(rig_.after(2.5)).held_s, 2.5, 1e-6);
    rig_.board(3).still = false;
    EXPECT_EQ(guide_.look(rig_.after(0.1)).hindrance, Hindrance::kMoves);
    EXPECT_EQ(guide_.guidance().board, 3);
    EXPECT_EQ(guide_.guidance().held_s, 0);
    rig_.board(3).still = true;
    EXPECT_EQ(guide_.look(rig_.after(0.1)).held_s, 0.0);
    EXPECT_NEAR(guide_.look(rig_.after(1)).held_s, 1, 1e-6);
}

TEST_F(SideGuideTest, NamesTheBoardThatSitsAskewFromTheSecondSideOn) {
    EXPECT_FALSE(guide_.look(rig_.after(0.1)).askew_rad[6]) << "nothing tells yet";
    takeSide({2, +1});
    takeSide({0, +1});
    rig_.lay({1, -1});
    const Vector3d up = Eigen::AngleAxisd(radians(7), Vector3d::UnitZ()) * Vector3d(0, -9.80665, 0);
    rig_.set(6, up, Vector3d::Zero());
    const Guidance& now = guide_.look(rig_.after(0.1));
    EXPECT_EQ(now.hindrance, Hindrance::kAskew);
    EXPECT_EQ(now.board, 6);
    EXPECT_NEAR(degrees(now.value), 7, 0.01);
    EXPECT_EQ(now.right_boards, 17);
}

TEST_F(SideGuideTest, NamesTheBoardThatIsSilentAndGoesOnWithoutIt) {
    rig_.board(11).silent = true;
    EXPECT_EQ(guide_.look(rig_.after(0.1)).hindrance, Hindrance::kAbsent);
    EXPECT_EQ(guide_.guidance().board, 11);
    guide_.skip(11, true);
    EXPECT_TRUE(guide_.look(rig_.after(0.1)).isRight());
    guide_.take();
    EXPECT_TRUE(guide_.isDone(4));
    guide_.skip(11, false);
    EXPECT_FALSE(guide_.isDone(4)) << "it lacks that side";
    EXPECT_TRUE(guide_.isDone(4, 10));
}

TEST_F(SideGuideTest, APlateInSomebodysHandsIsNoSide) {
    for (size_t board = 0; board < suit_.boards.size(); ++board)
        rig_.set(board, Vector3d(0, 6.9, 6.9), Vector3d::Zero());
    EXPECT_EQ(guide_.look(rig_.after(0.1)).hindrance, Hindrance::kBetweenSteps);
    EXPECT_FALSE(guide_.guidance().step);
}

TEST_F(SideGuideTest, ABoardUpsideDownAmongOthersIsNamed) {
    rig_.set(2, Vector3d(0, 0, -9.8), Vector3d::Zero());
    EXPECT_EQ(guide_.look(rig_.after(0.1)).hindrance, Hindrance::kElsewhere);
    EXPECT_EQ(guide_.guidance().board, 2);
}

TEST_F(SideGuideTest, ASideCanBeRepeated) {
    takeSide({2, +1});
    EXPECT_TRUE(guide_.isDone(4));
    guide_.repeat(4);
    EXPECT_FALSE(guide_.isDone(4));
    EXPECT_TRUE(guide_.look(rig_.after(0.1)).isRight());
}

TEST_F(SideGuideTest, WithoutReadingsItSaysSo) {
    HealthReport silent;
    silent.boards.resize(suit_.boards.size());
    EXPECT_EQ(guide_.look(silent).hindrance, Hindrance::kNoReadings);
    EXPECT_FALSE(guide_.isFinished());
}

}  // namespace
}  // namespace noctule
