// SPDX-License-Identifier: Apache-2.0
// What of a calibration is missing, in words: for Connect, Record, Review and the dialogs of processing.
#pragma once

#include <QString>

#include "core/live/readiness.h"
#include "core/suit/calibration_lack.h"

namespace noctule::ui {

/// "the gyroscopes of 3 boards and the rest pose"; empty: nothing is missing.
QString lackWords(const CalibrationLack& lack);
/// "Gyroscopes"
QString stepName(CalibrationStep step);
/// "This take has no calibration. Process it with one."; empty: nothing is missing.
QString takeLackSentence(const CalibrationLack& lack);
/// Why a check against the calibration would say nothing; empty: it can be made.
QString whyNotCheck(const CalibrationLack& lack);

/// Of a suit that is connected: "Not calibrated: the body cannot move yet." Empty: it is fit, and nothing is
/// due again.
QString fitSentence(const Readiness& readiness);
/// "Recording, without calibration of the gyroscopes"
QString recordingWords(const Readiness& readiness);

}  // namespace noctule::ui
