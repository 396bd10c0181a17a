// SPDX-License-Identifier: Apache-2.0
// Zero and matrix of every gyroscope from a turntable that turns evenly with each axis of the board up and
// down (Vlasic 2007, section 4.3), in any order, each board for itself; rests in between help the zeros.
// 33 1/3, 45 and 78 rpm. The table's true speed is read from gravity's ripple (turntable_speed.h), which
// beats the 0.1 % of the table; without a ripple the nominal speed counts, and the report says so. A zero
// wanders: the one found is its mean over the stretches, its sigma what it may have become by the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/board_side.h"
#include "core/calibration/findings.h"
#include "core/calibration/observations.h"

namespace noctule {

/// Limits of the verdict, in standard deviations as the fit sees them. 0.03 % of a full turn of a limb is
/// 0.1 degrees; at 0.2 % it is 0.7 and shows. A zero 0.02 deg/s off turns a limb by 0.2 degrees in the ten
/// seconds before the filter has found it; 0.2 deg/s is found by any rest pose, but no longer a calibration.
struct GyroscopeLimits {
    static constexpr double kGoodZero_rad_per_s = radians(0.02), kZero_rad_per_s = radians(0.2);
    static constexpr double kGoodSlope = 0.0003, kSlope = 0.002;
    /// Of the full scale: beyond it a table's start or a zero that is off clips.
    static constexpr double kFastest = 0.8;
    /// Of the nominal speed: what a good table keeps, what wants a word, and what is another speed.
    static constexpr double kTableSpread = 0.001, kOffSpeed = 0.005, kWrongSpeed = 0.05;
};

struct GyroscopeTurn {
    int take = 0;
    double begin_s = 0, end_s = 0;
    std::optional<BoardSide> up;     ///< none: a rest
    std::optional<BoardSide> about;  ///< turned right-handed about this axis; none: a rest
    Vector3d residual_rad_per_s = Vector3d::Zero();
    /// With the calibration in force; none: there is none but the nominal one.
    std::optional<Vector3d> residual_before_rad_per_s{};
};

struct GyroscopeBoard {
    Board board;
    Grade grade = Grade::kGood;
    std::optional<AxisCalibration> axes;  ///< none: not usable; with sigma_zero_counts
    Matrix3d sigma_matrix = Matrix3d::Zero();
    Vector3d sigma_mean_zero_counts = Vector3d::Zero();  ///< of the mean over the stretches alone
    std::vector<GyroscopeTurn> turns;

    double sigmaZero_rad_per_s() const;  ///< of the mean, worst axis; needs `axes`
    double sigmaSlope() const;           ///< relative, of the worst axis; needs `axes`
};

struct GyroscopeReport {
    double nominal_rpm = 0, rpm = 0, sigma_rpm = 0;
    bool speed_measured = false;  ///< else the nominal one counts
    /// How the zeros wandered, of all boards together: standard deviation of a step in a second.
    double wander_rad_per_s_per_sqrt_s = 0;
    std::vector<GyroscopeBoard> boards;  ///< in the order of the suits
    std::vector<Finding> findings;       ///< `part` is the board's id

    Grade grade() const { return gradeOf(findings); }
    /// `base` with the gyroscopes that were found; all else stays as it was.
    Calibration applied(const Calibration& base) const;
};

/// Takes of one suit, boards told apart by their ids. `nominal_rpm` 0: as the takes state, else the nearest
/// of 33 1/3, 45 and 78.
GyroscopeReport calibrateGyroscopes(const std::vector<Observations>& takes, double nominal_rpm);

}  // namespace noctule
