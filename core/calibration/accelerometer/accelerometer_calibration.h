// SPDX-License-Identifier: Apache-2.0
// Zero and matrix of every accelerometer from its six level sides (Vlasic 2007, section 4.3), in any order,
// each board for itself; tilted positions make the axes' squareness independent of the plate. The plate may
// be off level by 0.05 degrees about each axis: without tilted positions what lies off the diagonal is known
// to 0.035 degrees, with them to 0.025 (the rotation that |value| = g leaves open). Counts and m/s^2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/board_side.h"
#include "core/calibration/findings.h"
#include "core/calibration/observations.h"

namespace noctule {

/// Limits of the verdict, in standard deviations as the fit sees them. 5 mg tilt what stands upright by
/// 0.3 degrees, the most the design allows a board to add; 0.1 % of g is 1 mg and of a brisk 3 g swing 3 mg.
/// Beyond them the values are not usable; within two fifths of them nothing need be repeated.
struct AccelerometerLimits {
    static constexpr double kZero_m_per_s2 = 0.005 * kStandardGravity_m_per_s2;
    static constexpr double kSlope = 0.001;
    static constexpr double kGood = 0.4;
    /// Four times what the plate allows between two opposite sides.
    static constexpr double kLevel_rad = radians(0.3);
    /// In the norm; a board that lies still reads g to a tenth of it.
    static constexpr double kResidual_m_per_s2 = 0.03;
};

struct AccelerometerPosition {
    int take = 0;
    double begin_s = 0, end_s = 0;
    std::optional<BoardSide> side;  ///< none: tilted
    double residual_m_per_s2 = 0;   ///< |value| - g
    double off_level_rad = 0;       ///< of a side: where the other positions see it
    /// |value| - g with the calibration in force; none: there is none but the nominal one.
    std::optional<double> residual_before_m_per_s2{};
};

struct AccelerometerBoard {
    Board board;
    Grade grade = Grade::kGood;
    std::optional<AxisCalibration> axes;  ///< none: not usable; with sigma_zero_counts
    Matrix3d sigma_matrix = Matrix3d::Zero();
    std::vector<AccelerometerPosition> positions;

    double sigmaZero_m_per_s2() const;  ///< of the worst axis; needs `axes`
    double sigmaSlope() const;          ///< relative, of the worst axis; needs `axes`
};

struct AccelerometerReport {
    std::vector<AccelerometerBoard> boards;  ///< in the order of the suits
    std::vector<Finding> findings;           ///< `part` is the board's id

    Grade grade() const { return gradeOf(findings); }
    /// `base` with the accelerometers that were found; all else stays as it was.
    Calibration applied(const Calibration& base) const;
};

/// Takes of one suit, boards told apart by their ids.
AccelerometerReport calibrateAccelerometers(const std::vector<Observations>& takes);

}  // namespace noctule
