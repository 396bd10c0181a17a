// SPDX-License-Identifier: Apache-2.0
#include "core/guide/turn_guide.h"

#include <gtest/gtest.h>

#include "core/calibration/gyroscope/gyroscope_turns.h"
#include "tests/core/guide/rig_health.h"

namespace noctule {
namespace {

using test::RigHealth;

class TurnGuideTest : public testing::Test {
protected:
    TurnGuideTest() : guide_(suit_, nominalCalibration(suit_), test::kRigRate_hz, 0), rig_(suit_) {}
    const Guidance& turn(BoardSide up, BoardSide about, double rpm) {
        rig_.spin(up, about, turningRate_rad_per_s(rpm));
        return guide_.look(rig_.after(0.1));
    }
    const Guidance& rest(BoardSide up) {
        rig_.lay(up);
        return guide_.look(rig_.after(0.1));
    }

    Suit suit_ = test::rigSuit(18);
    TurnGuide guide_;
    RigHealth rig_;
};

TEST_F(TurnGuideTest, SeesEachTurnAndItsSpeed) {
    for (size_t side = 0; side < kBoardSides.size(); ++side) {
        EXPECT_EQ(rest(kBoardSides[side]).hindrance, Hindrance::kNotTurning);
        const Guidance& now = turn(kBoardSides[side], kBoardSides[side], 45);
        EXPECT_TRUE(now.isRight()) << side << ": " << static_cast<int>(now.hindrance);
        EXPECT_EQ(now.step, static_cast<int>(side));
        EXPECT_NEAR(*now.rpm, 45, 0.1);
        guide_.take();
    }
    EXPECT_TRUE(guide_.isFinished());
}

TEST_F(TurnGuideTest, ATableThatTurnsClockwiseAsksForTheOppositeSides) {
    rest({2, +1});
    const Guidance& now = turn({2, +1}, {2, -1}, 45);
    EXPECT_TRUE(now.isRight());
    EXPECT_EQ(now.step, 5) << "about -z";
    EXPECT_LT(*now.rpm, 0);
    EXPECT_FALSE(guide_.turnsCounterClockwise());
}

TEST_F(TurnGuideTest, SpunOneWayOnlyIsNeverFinished) {
    for (const BoardSide side : kBoardSides) {
        rest(side);
        // Upside down and backwards: about the same axis of the boards again.
        turn(side, {side.axis, +1}, 45);
        guide_.take();
    }
    EXPECT_FALSE(guide_.isFinished());
    EXPECT_TRUE(guide_.isDone(0));
    EXPECT_FALSE(guide_.isDone(1));
}

TEST_F(TurnGuideTest, SaysWhatIsWrongWithTheSpeed) {
    rest({2, +1});
    EXPECT_EQ(turn({2, +1}, {2, +1}, 41).hindrance, Hindrance::kOffSpeed);
    EXPECT_NEAR(guide_.guidance().value, 41, 0.1);
    EXPECT_TRUE(turn({2, +1}, {2, +1}, 100.0 / 3).isRight());
    EXPECT_TRUE(turn({2, +1}, {2, +1}, 78).isRight());
    suit_.boards[4].gyro_full_scale_rad_per_s = 10;
    TurnGuide paper(suit_, nominalCalibration(suit_), test::kRigRate_hz, 0);
    RigHealth rig(suit_, 0);
    rig.spin({2, +1}, {2, +1}, 8.5);
    EXPECT_EQ(paper.look(rig.after(0.1)).hindrance, Hindrance::kTooFast);
    EXPECT_EQ(paper.guidance().board, 4);
}

TEST_F(TurnGuideTest, WaitsUntilTheTableTurnsEvenly) {
    rest({2, +1});
    turn({2, +1}, {2, +1}, 44.1);
    for (size_t board = 0; board < suit_.boards.size(); ++board)
        rig_.board(board).still = false;
    const Guidance& now = guide_.look(rig_.after(0.1));
    EXPECT_EQ(now.hindrance, Hindrance::kUnevenTurn);
    EXPECT_NEAR(now.value, 44.1, 0.1);
}

}  // namespace
}  // namespace noctule
