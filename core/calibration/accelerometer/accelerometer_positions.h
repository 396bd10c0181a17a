// SPDX-License-Identifier: Apache-2.0
// Where one board lay still: its positions and their means, and what disturbed the others. From raw readings.
#pragma once

#include <vector>

#include "core/calibration/accelerometer/accelerometer_fit.h"
#include "core/calibration/steady_stretches.h"

namespace noctule {

struct BoardStillness {
    std::vector<SteadyStretch> stretches;
    std::vector<StillPosition> positions;  ///< of each stretch; sides not yet told
    std::vector<SteadyStretch> disturbed;  ///< too short, or creeping
    bool clipped = false;                  ///< a stretch was left out because it was beyond the range
};

BoardStillness stillBoard(const BoardRecord& record, const std::vector<Observations>& takes);

/// Plain, of the accelerometer.
Vector3d plainMean(std::span<const CountReading> readings);

/// The nominal calibration with a zero good enough to tell sides. `positions` may not be empty.
AxisCalibration guessZero(const std::vector<StillPosition>& positions, const AxisCalibration& nominal);

}  // namespace noctule
