// SPDX-License-Identifier: Apache-2.0
#include "core/guide/placement_guide.h"

#include <gtest/gtest.h>

#include "core/guide/stand_guide.h"
#include "tests/core/guide/rig_health.h"

namespace noctule {
namespace {

using test::RigHealth;

/// Three placements of eight boards and two sources, whose offsets shift all they say.
class PlacementGuideTest : public testing::Test {
protected:
    PlacementGuideTest() {
        suit_.sources.resize(2);
        suit_.sources[0].id = "s0";
        suit_.sources[1].id = "s1";
        for (const std::string placement : {"A", "B", "C"})
            for (int source = 0; source < 2; ++source)
                for (int board = 0; board < 8; ++board)
                    known_.distances.push_back({placement, "s" + std::to_string(source),
                                                "b" + std::to_string(board),
                                                distance_m(placement[0], source, board), 1e-3});
    }
    static double distance_m(char placement, int source, int board) {
        return 0.5 + 0.1 * std::sin(1.7 * placement + 2.3 * source + 3.1 * board);
    }
    HealthReport hear(char placement, double confidence = 0.9) {
        RigHealth rig(suit_);
        HealthReport health = rig.after(1);
        health.pairs.resize(16);
        for (int source = 0; source < 2; ++source)
            for (int board = 0; board < 8; ++board) {
                PairHealth& pair = health.pairs[static_cast<size_t>(source * 8 + board)];
                pair.age_s = 0.05;
                pair.confidence = confidence;
                pair.distance_m = distance_m(placement, source, board) + 0.04 + 0.01 * source;
            }
        return health;
    }

    Suit suit_ = test::rigSuit(8);
    KnownDistances known_;
};

TEST_F(PlacementGuideTest, HearsWhichPlacementStandsThere) {
    PlacementGuide guide(suit_, nominalCalibration(suit_), test::kRigRate_hz, known_);
    ASSERT_EQ(guide.stepCount(), 3);
    for (const char placement : {'B', 'A', 'C'}) {
        const Guidance& now = guide.look(hear(placement));
        EXPECT_TRUE(now.isRight());
        EXPECT_EQ(now.step, placement - 'A');
        guide.take();
    }
    EXPECT_TRUE(guide.isFinished());
}

TEST_F(PlacementGuideTest, WhatWasNotMeasuredIsNoPlacement) {
    PlacementGuide guide(suit_, nominalCalibration(suit_), test::kRigRate_hz, known_);
    EXPECT_EQ(guide.look(hear('D')).hindrance, Hindrance::kBetweenSteps);
}

TEST_F(PlacementGuideTest, SaysWhenTooFewPairsAreHeard) {
    PlacementGuide guide(suit_, nominalCalibration(suit_), test::kRigRate_hz, known_);
    EXPECT_EQ(guide.look(hear('A', 0.1)).hindrance, Hindrance::kUnheard);
    EXPECT_EQ(guide.guidance().value, 0);
}

TEST(StandGuide, APersonMaySwayButNotStep) {
    const Suit suit = test::rigSuit(3);
    StandGuide guide(suit, nominalCalibration(suit), test::kRigRate_hz);
    RigHealth rig(suit);
    rig.board(1).means->gyro_deviation_rad_per_s = 0.06;
    EXPECT_TRUE(guide.look(rig.after(0.1)).isRight());
    rig.board(1).means->gyro_deviation_rad_per_s = 0.5;
    EXPECT_EQ(guide.look(rig.after(0.1)).hindrance, Hindrance::kMoves);
    EXPECT_EQ(guide.guidance().board, 1);
}

}  // namespace
}  // namespace noctule
