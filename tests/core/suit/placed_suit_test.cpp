// SPDX-License-Identifier: Apache-2.0
#include "core/suit/placed_suit.h"

#include <gtest/gtest.h>

#include "core/suit/default_suit.h"

namespace noctule {
namespace {

TEST(PlacedSuit, PartsSitWhereTheCalibrationFoundThem) {
    const Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    calibration.boards[3].p_segment_board_m = Vector3d(1, 2, 3);
    calibration.boards[4].q_segment_board = Quaterniond(0, 1, 0, 0);
    SourceCalibration source;
    source.id = suit.sources[2].id;
    source.p_segment_source_m = Vector3d(4, 5, 6);
    calibration.sources.push_back(source);

    const Suit placed = placedSuit(suit, calibration);
    EXPECT_EQ(placed.boards[3].p_segment_board_m, Vector3d(1, 2, 3));
    EXPECT_TRUE(placed.boards[3].q_segment_board.isApprox(suit.boards[3].q_segment_board));
    EXPECT_TRUE(placed.boards[4].q_segment_board.isApprox(Quaterniond(0, 1, 0, 0)));
    EXPECT_EQ(placed.boards[4].p_segment_board_m, suit.boards[4].p_segment_board_m);
    EXPECT_EQ(placed.sources[2].p_segment_source_m, Vector3d(4, 5, 6));
    EXPECT_EQ(placed.sources[1].p_segment_source_m, suit.sources[1].p_segment_source_m);
}

}  // namespace
}  // namespace noctule
