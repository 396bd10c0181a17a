// SPDX-License-Identifier: Apache-2.0
#include "core/report/calibration_comparison.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

Calibration twoBoardsAndASource() {
    Suit suit;
    for (const char* id : {"chest", "head"}) {
        suit.boards.emplace_back();
        suit.boards.back().id = id;
    }
    Calibration calibration = nominalCalibration(suit);
    for (BoardCalibration& board : calibration.boards) {
        board.q_segment_board = Quaterniond::Identity();
        board.p_segment_board_m = Vector3d::Zero();
    }
    SourceCalibration source;
    source.id = "hat";
    source.offsets_s["inflection"] = 1.2e-4;
    calibration.sources.push_back(source);
    return calibration;
}

TEST(CalibrationComparison, TwoThatAreAlikeHaveNoTables) {
    EXPECT_TRUE(compareCalibrations(twoBoardsAndASource(), twoBoardsAndASource()).empty());
}

TEST(CalibrationComparison, SaysWhatDiffersInUnitsOfTheBody) {
    const Calibration one = twoBoardsAndASource();
    Calibration other = one;
    BoardCalibration& head = other.boards[1];
    head.q_segment_board = axisAngle(Vector3d::UnitX(), radians(3));
    head.p_segment_board_m = Vector3d(0, 0.004, 0);
    head.gyro.zero_counts.x() += 10;
    head.accel.matrix(1, 1) *= 1.02;
    other.sources[0].offsets_s["inflection"] += 3e-6;
    const auto tables = compareCalibrations(one, other);
    ASSERT_EQ(tables.size(), 2);
    ASSERT_EQ(tables[0].rows.size(), 1) << "the chest's board is as it was";
    const double zero_deg_per_s = degrees(10 * one.boards[1].gyro.matrix(0, 0));
    char zero[16];
    std::snprintf(zero, sizeof zero, "%.3f", zero_deg_per_s);
    EXPECT_EQ(tables[0].rows[0],
              (std::vector<std::string>{"head", "3.00", "4.0", zero, "0.000", "0.0", "2.000"}));
    EXPECT_EQ(tables[1].rows, (std::vector<std::vector<std::string>>{{"hat", "3.0", "–"}}));
}

TEST(CalibrationComparison, MagnetometersStandByThemselves) {
    Calibration one = twoBoardsAndASource();
    one.boards[0].mag = one.boards[1].mag = AxisCalibration::nominal(100);
    Calibration other = one;
    EXPECT_TRUE(compareCalibrations(one, other).empty());
    other.boards[0].mag->zero_counts.y() += 2048 * 0.05;
    other.boards[0].mag->matrix(2, 2) *= 1.03;
    other.boards[1].mag.reset();
    const auto tables = compareCalibrations(one, other);
    ASSERT_EQ(tables.size(), 1);
    EXPECT_EQ(tables[0].rows,
              (std::vector<std::vector<std::string>>{{"chest", "5.00", "3.000"}, {"head", "–", "–"}}));
}

TEST(CalibrationComparison, WhatOnlyOneKnowsIsShownAsUnknown) {
    const Calibration one = twoBoardsAndASource();
    Calibration other = one;
    other.boards.pop_back();
    other.boards[0].q_segment_board.reset();
    other.boards[0].p_segment_board_m = Vector3d(0.001, 0, 0);
    const auto tables = compareCalibrations(one, other);
    ASSERT_EQ(tables.size(), 1);
    EXPECT_EQ(tables[0].rows[0][1], "–");
    EXPECT_EQ(tables[0].rows[0][2], "1.0");
    EXPECT_EQ(tables[0].rows[1], (std::vector<std::string>{"head", "–", "–", "–", "–", "–", "–"}));
    EXPECT_EQ(compareCalibrations(other, one)[0].rows.size(), 2) << "whichever of the two knows it";
    Calibration mounted = one;
    mounted.boards[1].q_segment_board.reset();
    ASSERT_EQ(compareCalibrations(one, mounted).size(), 1);
    EXPECT_EQ(compareCalibrations(one, mounted)[0].rows[0][1], "–");
    EXPECT_EQ(compareCalibrations({}, one).size(), 2) << "nothing was in use";
}

}  // namespace
}  // namespace noctule
