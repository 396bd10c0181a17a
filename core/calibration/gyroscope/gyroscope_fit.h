// SPDX-License-Identifier: Apache-2.0
// Zero and matrix of one gyroscope from even turns and rests: counts = zero(t) + matrix^-1 rate, linear least
// squares with a zero of its own for each stretch that wanders from one to the next. Two turns of opposite
// rate give slope and zero (Vlasic 2007, section 4.3); the axes across them give what lies off the diagonal,
// as square as board and seat are. The Earth's own turn, at most 0.004 deg/s, goes into the zero.
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/count_mean.h"
#include "core/suit/calibration.h"

namespace noctule {

struct KnownRate {
    CountMean mean;
    double begin_s = 0, end_s = 0;
    int take = 0;
    Vector3d rate_rad_per_s = Vector3d::Zero();
    /// On one clock for all takes. Absent: the zero may have jumped from one take to another.
    std::optional<double> take_began_s{};
};

struct GyroscopeFit {
    AxisCalibration axes;  ///< rad/s; zero: its mean over the stretches, with sigma_zero_counts
    Matrix3d sigma_matrix = Matrix3d::Zero();
    std::vector<Vector3d> zeros_counts;  ///< of each stretch
    double chi_square = 0;               ///< over all three axes, measurements and wandering without jumps
    double freedoms = 0;                 ///< what chi_square is on average
    /// That the board was switched off between two takes of one sitting. Sigmas contain it.
    double restart_probability = 0;
};

/// `stretches` in order of time, with three different axes of turning. `wander_counts2_per_s`: variance of a
/// zero's steps, per second.
GyroscopeFit fitGyroscope(const std::vector<KnownRate>& stretches, double wander_counts2_per_s);

}  // namespace noctule
