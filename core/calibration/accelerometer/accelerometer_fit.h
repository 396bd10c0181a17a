// SPDX-License-Identifier: Apache-2.0
// Zero and matrix of one accelerometer from positions in which it lay still: Gauss-Newton on |value| = g in
// all of them (Frosio et al. 2009, "Autocalibration of MEMS accelerometers") and, on a level side, on
// horizontal axes that read 0 (Vlasic 2007, section 4.3). |value| = g alone leaves a rotation open and, with
// six level sides, all that lies off the diagonal: there the sides' levels decide, and sigma says how well.
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/board_side.h"
#include "core/calibration/count_mean.h"
#include "core/suit/calibration.h"

namespace noctule {

struct StillPosition {
    CountMean mean;
    double g_m_per_s2 = kStandardGravity_m_per_s2;
    std::optional<BoardSide> level;  ///< none: tilted, only |value| = g holds
    double sigma_level_rad = 0;      ///< about each horizontal axis
};

struct AccelerometerFit {
    AxisCalibration axes;  ///< m/s^2; with sigma_zero_counts
    Matrix3d sigma_matrix = Matrix3d::Zero();
    int iterations = 0;
    bool converged = false;

    Vector3d value(const StillPosition& position) const { return axes.apply(position.mean.counts); }
    /// |value| - g
    double residual_m_per_s2(const StillPosition& position) const;
    /// Between a side's axis and the value.
    double angle_rad(const StillPosition& position, BoardSide side) const;
};

/// `start` is the nominal calibration with a guessed zero. What the positions leave open stays near it: axes
/// within 2 degrees, scale within 5 %, zero within 10 m/s^2, each as a standard deviation.
AccelerometerFit fitAccelerometer(const std::vector<StillPosition>& positions, const AxisCalibration& start);

}  // namespace noctule
