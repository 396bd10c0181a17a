// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration_steps.h"

#include <gtest/gtest.h>

#include "core/suit/default_suit.h"

namespace noctule {
namespace {

TEST(CalibrationSteps, TheOldestAndTheWorstPartCount) {
    const Suit suit = defaultSuit();
    Calibration calibration = nominalCalibration(suit);
    CalibrationStepState state = stateOfStep(CalibrationStep::kGyroscopes, suit, calibration);
    EXPECT_EQ(state.made, 0);
    EXPECT_EQ(state.parts, static_cast<int>(suit.boards.size()));
    EXPECT_EQ(state.unstated, 0);
    EXPECT_FALSE(state.isOld()) << "its age is not known";
    for (BoardCalibration& board : calibration.boards)
        board.made["gyroscopes"] = {"2026-03-02T10:00:00Z", "usable"};
    calibration.boards[1].made["gyroscopes"].verdict = "a word of a later program";
    calibration.boards[2].made["gyroscopes"] = {"2026-03-01T10:00:00Z", "not usable"};
    calibration.boards[3].made.clear();
    state = stateOfStep(CalibrationStep::kGyroscopes, suit, calibration);
    EXPECT_EQ(state.made, static_cast<int>(suit.boards.size()) - 1);
    EXPECT_EQ(state.oldest_utc, "2026-03-01T10:00:00Z");
    EXPECT_TRUE(state.isNotUsable());
    EXPECT_EQ(stateOfStep(CalibrationStep::kAccelerometers, suit, calibration).made, 0);
}

TEST(CalibrationSteps, EachLastsAsLongAsItsWizardSays) {
    CalibrationStepState state;
    const auto isOldAfter = [&](CalibrationStep step, double days) {
        state.step = step;
        state.age_h = 24 * days;
        return state.isOld();
    };
    EXPECT_FALSE(isOldAfter(CalibrationStep::kSources, 364));
    EXPECT_TRUE(isOldAfter(CalibrationStep::kSources, 366));
    for (const CalibrationStep step :
         {CalibrationStep::kAccelerometers, CalibrationStep::kGyroscopes, CalibrationStep::kMagnetometers}) {
        EXPECT_FALSE(isOldAfter(step, 91));
        EXPECT_TRUE(isOldAfter(step, 93));
    }
    for (const CalibrationStep step : {CalibrationStep::kRestPose, CalibrationStep::kMovement}) {
        EXPECT_FALSE(isOldAfter(step, 0.4));
        EXPECT_TRUE(isOldAfter(step, 0.6));
    }
}

}  // namespace
}  // namespace noctule
