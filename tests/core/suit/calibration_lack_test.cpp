// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration_lack.h"

#include <gtest/gtest.h>

#include "core/suit/calibration_entries.h"
#include "core/suit/calibration_parts.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

const CalibrationMade kMadeOnce{"2026-03-01T10:00:00Z", "good"};

void markMade(Calibration& calibration, const char* task) {
    for (BoardCalibration& board : calibration.boards)
        board.made[task] = kMadeOnce;
}

void makeOffsets(const Suit& suit, Calibration& calibration) {
    for (const Source& source : suit.sources) {
        entryOf(calibration, source).offsets_s["inflection"] = 1.3e-4;
        entryOf(calibration, source).made["sources"] = kMadeOnce;
    }
}

TEST(CalibrationLack, NominalValuesCountForNothing) {
    const Suit suit = defaultSuit();
    for (const Calibration& calibration : {Calibration{}, nominalCalibration(suit)}) {
        const CalibrationLack lack = lackOf(suit, calibration);
        EXPECT_TRUE(lack.isTotal());
        EXPECT_TRUE(lack.stopsTheBody());
        EXPECT_EQ(lack.gyroscopes.size(), suit.boards.size());
        EXPECT_EQ(gradeOf(lack, "AGD"), Grade::kNotUsable);
        EXPECT_EQ(lackSentence(lack), "This take has no calibration. Process it with one.");
    }
}

TEST(CalibrationLack, OfAccelerometersAloneTheRestIsNamed) {
    const Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    markMade(calibration, "accelerometers");
    const CalibrationLack lack = lackOf(suit, calibration);
    EXPECT_FALSE(lack.isTotal());
    EXPECT_EQ(lackInWords(lack), "source offsets, gyroscopes and rest pose");
    EXPECT_EQ(gradeOf(lack, "AGD"), Grade::kNotUsable);
    EXPECT_EQ(gradeOf(lack, "A"), Grade::kUsable) << "boards sit where the suit file says, or elsewhere";
}

TEST(CalibrationLack, ARestPoseFindsZerosButNoGyroscope) {
    const Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    makeOffsets(suit, calibration);
    markMade(calibration, "accelerometers");
    markMade(calibration, "rest-pose");
    for (BoardCalibration& board : calibration.boards)
        board.gyro.zero_counts.x() += 17;
    EXPECT_EQ(lackInWords(lackOf(suit, calibration)), "gyroscopes");
    markMade(calibration, "gyroscopes");
    EXPECT_TRUE(lackOf(suit, calibration).isNone());
    EXPECT_EQ(lackSentence(lackOf(suit, calibration)), "");
    calibration.boards[4].made.erase("gyroscopes");
    const CalibrationLack lack = lackOf(suit, calibration);
    EXPECT_EQ(lack.gyroscopes, std::vector{4});
    EXPECT_EQ(lackInWords(lack), "gyroscopes of 1 board");
    EXPECT_EQ(gradeOf(lack, "AGD"), Grade::kUsable);
    EXPECT_EQ(gradeOf(lack, "AD"), Grade::kGood);
    EXPECT_FALSE(lack.stopsTheBody());
}

TEST(CalibrationLack, AFileWithoutHistoryIsBelievedWhenItHasOffsets) {
    const Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    for (const Source& source : suit.sources)
        entryOf(calibration, source).offsets_s["start"] = 1e-5;
    EXPECT_TRUE(lackOf(suit, calibration).isNone());
    calibration.boards.pop_back();
    EXPECT_EQ(lackOf(suit, calibration).gyroscopes.size(), 1U) << "a board that it does not know";
}

TEST(CalibrationLack, OfARoomOnlyItsSourcesAreCalibrated) {
    Suit room = defaultSuit();
    for (Board& board : room.boards)
        board.segment.clear();
    EXPECT_FALSE(room.isFixed()) << "somebody wears its sources";
    for (Source& source : room.sources)
        source.segment.clear();
    EXPECT_TRUE(room.isFixed());
    Calibration calibration = nominalCalibration(room);
    EXPECT_EQ(lackInWords(lackOf(room, calibration)), "source offsets");
    makeOffsets(room, calibration);
    EXPECT_TRUE(lackOf(room, calibration).isNone());
}

TEST(CalibrationParts, TheWearingIsLeftOutAndSensorsStay) {
    const Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    makeOffsets(suit, calibration);
    markMade(calibration, "gyroscopes");
    markMade(calibration, "rest-pose");
    calibration.boards[0].q_segment_board = Quaterniond(0.5, 0.5, 0.5, 0.5);
    calibration.boards[0].sigma_mounting_rad = Vector3d::Constant(0.02);
    const Calibration parts = withoutWearing(calibration);
    EXPECT_FALSE(parts.boards[0].q_segment_board);
    EXPECT_FALSE(parts.boards[0].sigma_mounting_rad);
    EXPECT_FALSE(parts.boards[0].made.contains("rest-pose"));
    EXPECT_TRUE(parts.boards[0].made.contains("gyroscopes"));
    EXPECT_EQ(parts.sources[0].offsets_s, calibration.sources[0].offsets_s);
}

TEST(CalibrationParts, NewerValuesAreTakenOfTheSamePartsOnly) {
    const Suit suit = defaultSuit();
    Calibration base = nominalCalibration(suit);
    markMade(base, "gyroscopes");
    base.boards[1].serial = "NB-1";
    Calibration other = base;
    for (BoardCalibration& board : other.boards)
        board.gyro.matrix *= 1.01;
    Calibration same = base;
    EXPECT_FALSE(takeNewerParts(same, other)) << "made at the same time";
    for (BoardCalibration& board : other.boards)
        board.made["gyroscopes"].created_utc = "2026-04-01T10:00:00Z";
    other.boards[1].serial = "NB-2";
    EXPECT_TRUE(takeNewerParts(same, other));
    EXPECT_EQ(same.boards[0].gyro.matrix, other.boards[0].gyro.matrix);
    EXPECT_EQ(same.boards[1].gyro.matrix, base.boards[1].gyro.matrix) << "another board by its serial number";
    EXPECT_EQ(same.boards[0].made.at("gyroscopes").created_utc, "2026-04-01T10:00:00Z");
}

}  // namespace
}  // namespace noctule
