// SPDX-License-Identifier: Apache-2.0
// The steps of a calibration: for how many parts each has values, when the oldest were made, how good the
// worst are, and how long they hold. The one place for the intervals; wizards and readiness ask here.
#pragma once

#include <string>

#include "core/suit/calibration.h"

namespace noctule {

enum class CalibrationStep {
    kSources,
    kAccelerometers,
    kGyroscopes,
    kMagnetometers,
    kRestPose,
    kMovement,
};
inline constexpr CalibrationStep kCalibrationSteps[] = {
    CalibrationStep::kSources,       CalibrationStep::kAccelerometers, CalibrationStep::kGyroscopes,
    CalibrationStep::kMagnetometers, CalibrationStep::kRestPose,       CalibrationStep::kMovement};

/// In CalibrationHistory and on the command line: "rest-pose".
const char* keyOf(CalibrationStep step);
/// Offsets hold for a year, sensors for three months. What belongs to a wearing holds for 12 hours: nobody
/// wears a suit longer.
double lastsFor_h(CalibrationStep step);
/// It is made anew each time the suit is put on.
bool isOfWearing(CalibrationStep step);

struct CalibrationStepState {
    CalibrationStep step = CalibrationStep::kSources;
    int made = 0, parts = 0;
    int unstated = 0;        ///< parts with values, but without a record of when and how good
    std::string oldest_utc;  ///< empty: none was made
    std::string worst;       ///< "good", "usable", "not usable"
    double age_h = -1;       ///< of the oldest, from whoever reads a clock; negative: not known

    bool isNotUsable() const;
    bool isOld() const { return age_h > lastsFor_h(step); }
};

/// Of a suit without parts those of the calibration count.
CalibrationStepState stateOfStep(CalibrationStep step, const Suit& suit, const Calibration& calibration);

}  // namespace noctule
