// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/steady_stretches.h"

#include <gtest/gtest.h>

#include "core/body/text.h"
#include "core/calibration/board_side.h"
#include "core/calibration/worn_part_names.h"
#include "tests/core/calibration/inertial_bench.h"

namespace noctule {
namespace {

TEST(BoardSide, HasItsNameAndItsAxis) {
    EXPECT_EQ((BoardSide{0, +1}.name()), "+x");
    EXPECT_EQ((BoardSide{2, -1}.name()), "-z");
    EXPECT_EQ((BoardSide{1, -1}.up()), -Vector3d::UnitY());
    EXPECT_EQ((BoardSide{1, -1}.opposite()), (BoardSide{1, +1}));
    EXPECT_EQ(BoardSide::nearest({0.2, -9.7, 1.0}), (BoardSide{1, -1}));
    for (const BoardSide side : kBoardSides)
        EXPECT_EQ(BoardSide::nearest(side.up()), side);
}

TEST(BoardWords, NameABoardAsTheOperatorSeesIt) {
    Suit suit = defaultSuit();
    EXPECT_EQ(boardWords(suit, 6), "board 7, left forearm");
    EXPECT_EQ(boardWords(suit, 0), "board 1, pelvis");
    suit.boards[2].segment = "Tail";
    EXPECT_EQ(boardWords(suit, 2), "board 3, Tail");
    EXPECT_EQ(text::number(-0.04, 1), "0.0");
    EXPECT_EQ(text::number(-1.26, 1), "\u22121.3");
}

/// Every station of a rig, and nothing that moves.
void expectStations(const test::ObservedTake& take, bool turns) {
    const std::vector<Observations> takes{take.observations};
    for (const BoardRecord& record : boardRecords(takes)) {
        std::vector<SteadyStretch> found;
        for (const SteadyStretch& stretch : record.steadyStretches())
            if (stretch.length_s() > 1)
                found.push_back(stretch);
        ASSERT_EQ(found.size(), 6U) << record.words;
        for (size_t k = 0; k < found.size(); ++k) {
            const simulation::RigStation& station = take.stage.stations[k];
            EXPECT_GT(found[k].begin_s, station.begin_s) << record.words << ", " << station.label;
            EXPECT_LT(found[k].end_s, station.end_s);
            const double begin_s = std::max(station.begin_s, record.parts[0].readings->front().time_s);
            EXPECT_GT(found[k].length_s(), station.end_s - begin_s - 1.1);
            EXPECT_EQ(found[k].turns, turns);
        }
    }
}

TEST(SteadyStretches, AreTheStationsOfPlateAndTable) {
    expectStations(test::plateTake(), false);
    expectStations(test::tableTake(), true);
}

TEST(SteadyStretches, EndWhereReadingsAreMissing) {
    Observations all = test::tableTake().observations;
    const double middle_s =
        (test::tableTake().stage.stations[0].begin_s + test::tableTake().stage.stations[0].end_s) / 2;
    test::removeReadings(all, 1, {middle_s, middle_s + 0.2, ""});
    const std::vector<Observations> takes{all};
    const std::vector<SteadyStretch> found = boardRecords(takes)[1].steadyStretches();
    for (const SteadyStretch& stretch : found)
        EXPECT_FALSE(stretch.begin_s < middle_s && stretch.end_s > middle_s);
}

}  // namespace
}  // namespace noctule
