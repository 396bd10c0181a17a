// SPDX-License-Identifier: Apache-2.0
// What one board did on a turntable: its even turns and its rests, each turn by the axis that turned and the
// side that was up. All from raw readings.
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/board_side.h"
#include "core/calibration/count_mean.h"
#include "core/calibration/findings.h"
#include "core/calibration/steady_stretches.h"

namespace noctule {

struct TableStretch {
    SteadyStretch steady;
    CountMean gyro;
    std::optional<BoardSide> about;  ///< right-handed about this axis; none: a rest
    std::optional<BoardSide> up;     ///< of a turn
};

struct TableBoard {
    const BoardRecord* record = nullptr;
    std::vector<TableStretch> stretches;  ///< in order of time
    bool clipped = false;                 ///< a turn was left out because its rate was beyond the range

    bool turned(BoardSide about) const;
    /// Nominal, along the axes; their zeros cancel over both directions. Empty without turns.
    std::vector<double> speeds_rad_per_s() const;
};

TableBoard tableBoard(const BoardRecord& record);

/// What keeps the board from being calibrated, or from being better.
std::vector<Finding> turnFindings(const TableBoard& table, double nominal_rpm);

/// The nearest of a turntable's usual speeds, 33 1/3, 45 and 78.
double nearestTableSpeed_rpm(double rpm);
double turningRate_rad_per_s(double rpm);
/// "33.3 rpm"
std::string speedWords(double rpm);

}  // namespace noctule
