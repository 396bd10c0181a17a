// SPDX-License-Identifier: Apache-2.0
#include "core/suit/placed_suit.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(PlacedSuit, AnAnchorThatWasTurnedFacesElsewhere) {
    Suit room;
    room.boards.emplace_back().id = "a";
    room.sources.emplace_back().id = "a";
    room.boards[0].q_segment_board = Quaterniond(0.6, 0, 0.8, 0);
    room.sources[0].normal_segment = Vector3d::UnitX();
    room.sources[0].board = "a";
    Calibration calibration = nominalCalibration(room);
    EXPECT_EQ(placedSuit(room, calibration).sources[0].normal_segment, Vector3d::UnitX());
    const Quaterniond quarter(Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitY()));
    calibration.boards[0].q_segment_board = quarter * room.boards[0].q_segment_board;
    EXPECT_TRUE(placedSuit(room, calibration).sources[0].normal_segment.isApprox(-Vector3d::UnitZ()));
    room.sources[0].segment = "Chest";  // on a person a source's own calibration tells
    EXPECT_EQ(placedSuit(room, calibration).sources[0].normal_segment, Vector3d::UnitX());
}

}  // namespace
}  // namespace noctule
