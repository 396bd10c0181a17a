// SPDX-License-Identifier: Apache-2.0
// Whose a calibration is.
#include "core/suit/calibration_parts.h"

#include <gtest/gtest.h>

#include "core/suit/default_suit.h"

namespace noctule {
namespace {

TEST(CalibrationOwner, PartsSayMoreThanTheBox) {
    Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    calibration.sources.push_back({.id = suit.sources[0].id, .offsets_s = {}, .sigma_s = {}});
    EXPECT_FALSE(namesItsSuit(calibration));
    EXPECT_EQ(ownerOf(calibration, suit, "NB-1"), CalibrationOwner::kUnknown) << "an old file";
    calibration.box_serial = "NB-1";
    EXPECT_TRUE(namesItsSuit(calibration));
    EXPECT_EQ(ownerOf(calibration, suit, "NB-1"), CalibrationOwner::kThisSuit);
    EXPECT_EQ(ownerOf(calibration, suit, "NB-2"), CalibrationOwner::kAnotherSuit);
    EXPECT_EQ(ownerOf(calibration, suit, ""), CalibrationOwner::kUnknown) << "nothing is connected";

    suit.boards[0].serial = "B-1";
    calibration.boards[0].serial = "B-1";
    EXPECT_EQ(ownerOf(calibration, suit, "NB-2"), CalibrationOwner::kThisSuit) << "its boards in another box";
    calibration.boards[0].serial = "B-9";
    EXPECT_EQ(ownerOf(calibration, suit, "NB-1"), CalibrationOwner::kAnotherSuit)
        << "other boards in the box";
    suit.boards[1].serial = calibration.boards[1].serial = "B-2";
    EXPECT_EQ(ownerOf(calibration, suit, "NB-1"), CalibrationOwner::kThisSuit) << "one board was exchanged";
}

/// A calibration of sources alone names no board.
TEST(CalibrationOwner, SourcesNameASuitToo) {
    Suit suit = defaultSuit();
    suit.sources[0].serial = "S-1";
    Calibration calibration = nominalCalibration(suit);
    calibration.sources.push_back({.id = suit.sources[0].id, .offsets_s = {}, .sigma_s = {}});
    calibration.sources[0].serial = "S-2";
    EXPECT_TRUE(namesItsSuit(calibration));
    EXPECT_EQ(ownerOf(calibration, suit, ""), CalibrationOwner::kAnotherSuit);
    calibration.sources[0].serial = "S-1";
    EXPECT_EQ(ownerOf(calibration, suit, ""), CalibrationOwner::kThisSuit);
}

}  // namespace
}  // namespace noctule
