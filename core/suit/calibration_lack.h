// SPDX-License-Identifier: Apache-2.0
// Which parts of a suit have no calibrated values. The one place that says whether a suit or a take counts as
// calibrated: readiness, recording, verdicts and reports ask here.
#pragma once

#include <string>
#include <vector>

#include "core/job/grade.h"
#include "core/suit/calibration.h"

namespace noctule {

/// Indices into the suit. A calibration without any history is believed when it has source offsets: such
/// files come from other programs and from the simulation. Nominal values never count. Of a room only
/// its sources need calibration.
struct CalibrationLack {
    std::vector<int> sources;  ///< without offsets
    std::vector<int> accelerometers, gyroscopes, rest_pose;
    int source_count = 0, board_count = 0;

    bool isNone() const;
    /// No distance can be measured.
    bool ofAllOffsets() const;
    bool ofMostGyroscopes() const;
    /// Nothing was ever calibrated.
    bool isTotal() const;
    /// The body cannot move: no distances, or rates that drift by tens of degrees a second.
    bool stopsTheBody() const { return ofAllOffsets() || ofMostGyroscopes(); }
};

/// Of one board: its sensor was calibrated, and is not only nominal.
bool knowsAccelerometer(const Board& board, const BoardCalibration* known);
bool knowsGyroscope(const Board& board, const BoardCalibration* known);

CalibrationLack lackOf(const Suit& suit, const Calibration& calibration);

/// "source offsets, gyroscopes of 3 boards and rest pose"; empty: nothing is missing.
std::string lackInWords(const CalibrationLack& lack);

/// What it makes of a result of these sensors, a subset of "AGD".
Grade gradeOf(const CalibrationLack& lack, const std::string& sensors);
/// For reports, warnings and the command line: "this take has no calibration. Process it with one."; as a
/// sentence of its own it begins with a capital. Empty: nothing is missing.
std::string lackClause(const CalibrationLack& lack);
std::string lackSentence(const CalibrationLack& lack);

}  // namespace noctule
