// SPDX-License-Identifier: Apache-2.0
// The part of a calibration that holds a board's or a source's values; added when it is not there.
#pragma once

#include "core/suit/calibration.h"

namespace noctule {

/// Added with nominal values.
BoardCalibration& entryOf(Calibration& calibration, const Board& board);
/// Added without any.
SourceCalibration& entryOf(Calibration& calibration, const Source& source);

}  // namespace noctule
