// SPDX-License-Identifier: Apache-2.0
#include "core/guide/field_guide.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/guide/rig_health.h"

namespace noctule {
namespace {

using test::RigHealth;

Suit suitWithField(int boards) {
    Suit suit = test::rigSuit(boards);
    for (Board& board : suit.boards)
        board.has_magnetometer = true;
    return suit;
}

class FieldGuideTest : public testing::Test {
protected:
    void begin(const Suit& suit) {
        suit_ = suit;
        guide_.emplace(suit_, nominalCalibration(suit_), test::kRigRate_hz);
        rig_.emplace(suit_, 0);
    }
    /// The field in the world, seen by all boards; each has a magnet of its own.
    const Guidance& look(const Vector3d& field_ut, bool carried) {
        HealthReport& report = rig_->report();
        const HealthReport& now = rig_->after(1 / 7.0);
        for (size_t board = 0; board < suit_.boards.size(); ++board) {
            BoardHealth& health = report.boards[board];
            health.still = !carried;
            health.means->accel_deviation_m_per_s2 = carried ? 1 : 0.03;
            if (!suit_.boards[board].has_magnetometer)
                continue;
            const Vector3d magnet_ut(6, -4, 2.0 * static_cast<double>(board));
            Vector3d counts = Vector3d::Constant(2048) + (field_ut + magnet_ut) * 2048 / 100;
            if (static_cast<int>(board) == loose_)
                counts += Vector3d(1, 1, 0) * 200 * normal_(random_);
            health.field = BoardHealth::Field{static_cast<double>(report.sample), counts};
        }
        return guide_->look(now);
    }
    void carryAtChest() {
        for (int i = 0; i < 40; ++i)
            look({20, -43.6, 0}, true);
        ASSERT_TRUE(guide_->guidance().isRight()) << static_cast<int>(guide_->guidance().hindrance);
        guide_->take();
        ASSERT_TRUE(guide_->isDone(FieldGuide::kSpot));
    }
    void carry() {
        carryAtChest();
        guide_->leaveOutFloor();
    }
    /// Lowered within a second, then held above a floor where the field is `times` as strong.
    void lower(double times) {
        for (int i = 0; i < 7; ++i)
            look((1 + (times - 1) * i / 7) * kEarth, true);
        for (int i = 0; i < 20; ++i)
            look(times * kEarth, false);
    }
    static inline const Vector3d kEarth{20, -43.6, 0};
    Vector3d anyDirection() {
        return 48 * Vector3d{normal_(random_), normal_(random_), normal_(random_)}.normalized();
    }

    Suit suit_;
    std::optional<FieldGuide> guide_;
    std::optional<RigHealth> rig_;
    std::mt19937 random_{7};
    std::normal_distribution<double> normal_;
    int loose_ = -1;
};

TEST_F(FieldGuideTest, TheSpotThenAllDirections) {
    begin(suitWithField(4));
    EXPECT_EQ(look({20, -43.6, 0}, false).hindrance, Hindrance::kCarry) << "too short a look";
    carry();
    EXPECT_NEAR(guide_->spot().strength_ut, 48, 8) << "the boards' own magnets are in it";
    EXPECT_EQ(look(anyDirection(), true).hindrance, Hindrance::kTurnOn);
    for (int i = 0; i < 900 && !guide_->guidance().isRight(); ++i)
        look(anyDirection(), true);
    EXPECT_TRUE(guide_->guidance().isRight()) << guide_->leastShare();
    EXPECT_EQ(guide_->enoughBoards(), 4);
    EXPECT_GE(guide_->leastShare(), 0.9);
    guide_->take();
    EXPECT_TRUE(guide_->isFinished());
    guide_->repeat(FieldGuide::kTurn);
    EXPECT_EQ(guide_->turnOf(0).readings().size(), 0u);
}

TEST_F(FieldGuideTest, TheFloorIsLookedAtOnceTheSuitIsDownThere) {
    begin(suitWithField(4));
    carryAtChest();
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(look(kEarth, false).hindrance, Hindrance::kLower) << "it was not moved yet";
    EXPECT_FALSE(guide_->spot().floor_percent);
    lower(1.2);
    EXPECT_TRUE(guide_->guidance().isRight()) << static_cast<int>(guide_->guidance().hindrance);
    guide_->take();
    ASSERT_TRUE(guide_->spot().floor_percent);
    EXPECT_NEAR(*guide_->spot().floor_percent, 20, 4) << "the boards' own magnets are in it";
    EXPECT_TRUE(guide_->spot().isBentAtFloor());
    EXPECT_EQ(look(anyDirection(), true).hindrance, Hindrance::kTurnOn) << "a bent floor holds nobody up";
    guide_->repeat(FieldGuide::kFloor);
    EXPECT_FALSE(guide_->spot().floor_percent);
    lower(1);
    EXPECT_TRUE(guide_->guidance().isRight());
    EXPECT_FALSE(guide_->spot().isBentAtFloor());
}

TEST_F(FieldGuideTest, TiltedAtTheFloorItIsNotCompared) {
    begin(suitWithField(4));
    carryAtChest();
    rig_->lay({0, +1});
    lower(1);
    EXPECT_EQ(guide_->guidance().hindrance, Hindrance::kTilted);
    EXPECT_NEAR(degrees(guide_->guidance().value), 90, 1);
}

/// Each hindrance has a name of its own, so that the page can say it.
TEST_F(FieldGuideTest, WhoIsNotHeardIsTold) {
    begin(suitWithField(3));
    look(kEarth, true);
    for (BoardHealth& board : rig_->report().boards)
        board.field.reset();
    EXPECT_EQ(guide_->look(rig_->after(0.1)).hindrance, Hindrance::kNoField);
    for (BoardHealth& board : rig_->report().boards)
        board.silent = true;
    EXPECT_EQ(guide_->look(rig_->after(0.1)).hindrance, Hindrance::kNoReadings);
    for (BoardHealth& board : rig_->report().boards)
        board.silent = false;
    carry();
    rig_->board(1).silent = true;
    look(anyDirection(), true);
    EXPECT_EQ(guide_->guidance().hindrance, Hindrance::kAbsent);
    EXPECT_EQ(guide_->guidance().board, 1);
    EXPECT_EQ(guide_->guidance().hindering, 1);
    guide_->skip(1, true);
    EXPECT_EQ(look(anyDirection(), true).hindrance, Hindrance::kTurnOn);
}

TEST_F(FieldGuideTest, AMagnetometerThatFallsSilentLeavesNoOldReadingBehind) {
    begin(suitWithField(2));
    carry();
    look(anyDirection(), true);
    const size_t before = guide_->readingsOf(1).size();
    const auto last = rig_->board(1).field;
    for (int i = 0; i < 20; ++i) {
        rig_->after(0.1);
        rig_->board(0).field = BoardHealth::Field{static_cast<double>(rig_->report().sample), last->counts};
        guide_->look(rig_->report());
    }
    EXPECT_EQ(guide_->guidance().hindrance, Hindrance::kAbsent);
    EXPECT_EQ(guide_->guidance().board, 1);
    EXPECT_EQ(guide_->readingsOf(1).size(), before);
}

TEST_F(FieldGuideTest, WhatWasKeptIsGoneOnWith) {
    begin(suitWithField(2));
    carry();
    for (int i = 0; i < 300; ++i)
        look(anyDirection(), true);
    const double share = guide_->turnOf(0).sphere().share();
    ASSERT_GT(share, 0.3);
    const std::vector<FieldReading> kept = guide_->readingsOf(0);
    begin(suitWithField(2));
    guide_->give(0, kept);
    EXPECT_EQ(guide_->readingsOf(0).size(), kept.size());
    EXPECT_NEAR(guide_->turnOf(0).sphere().share(), share, 0.15) << "judged anew, from all of them";
    EXPECT_EQ(guide_->turnOf(1).readings().size(), 0u);
    guide_->startAnew(0);
    EXPECT_TRUE(guide_->readingsOf(0).empty());
}

/// The sensors' own iron would look like a bent field.
TEST_F(FieldGuideTest, WhileItIsTurnedTheSpotIsNotJudged) {
    begin(suitWithField(4));
    for (int i = 0; i < 40; ++i) {
        rig_->lay(i % 20 < 10 ? BoardSide{2, +1} : BoardSide{0, +1});
        look((1 + 0.2 * (i % 10) / 10.0) * Vector3d(20, -43.6, 0), true);
    }
    EXPECT_EQ(guide_->guidance().hindrance, Hindrance::kTilted);
    for (int i = 0; i < 50; ++i)
        look({20, -43.6, 0}, true);
    EXPECT_TRUE(guide_->guidance().isRight()) << "it lies on one side again";
}

TEST_F(FieldGuideTest, ASuitThatLiesStillSaysNothingOfTheSpot) {
    begin(suitWithField(2));
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(look(kEarth, false).hindrance, Hindrance::kCarry);
    carryAtChest();
}

TEST_F(FieldGuideTest, ABentSpotIsSaid) {
    begin(suitWithField(4));
    for (int i = 0; i < 40; ++i)
        look((1 + 0.2 * (i % 10) / 10.0) * Vector3d(20, -43.6, 0), true);
    EXPECT_EQ(guide_->guidance().hindrance, Hindrance::kBentField);
    EXPECT_GT(guide_->guidance().value, 5);
}

TEST_F(FieldGuideTest, OneSensorWithIronKeepsNobodyElseBack) {
    begin(suitWithField(4));
    carry();
    loose_ = 2;
    for (int i = 0; i < 900; ++i)
        look(anyDirection(), true);
    EXPECT_EQ(guide_->guidance().hindrance, Hindrance::kTurnOn);
    EXPECT_TRUE(guide_->carriesIronNow(2));
    EXPECT_FALSE(guide_->carriesIronNow(1));
    EXPECT_EQ(guide_->enoughBoards(), 3);
    guide_->skip(2, true);
    look(anyDirection(), true);
    EXPECT_TRUE(guide_->guidance().isRight());
}

TEST_F(FieldGuideTest, BoardsWithoutMagnetometerAreLeftOut) {
    Suit suit = suitWithField(3);
    suit.boards[1].has_magnetometer = false;
    begin(suit);
    EXPECT_TRUE(guide_->isSkipped(1));
    carry();
    EXPECT_NE(guide_->leastBoard(), 1);
    begin(test::rigSuit(2));
    EXPECT_EQ(look({20, -43.6, 0}, true).hindrance, Hindrance::kNoReadings);
    EXPECT_EQ(guide_->leastShare(), 0);
}

}  // namespace
}  // namespace noctule
