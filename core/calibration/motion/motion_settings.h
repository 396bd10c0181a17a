// SPDX-License-Identifier: Apache-2.0
// What a calibration from motion takes for granted before it has seen the movement: standard deviations per
// axis. Larger ones let the data move things farther.
#pragma once

#include "core/math/conventions.h"

namespace noctule {

struct MotionSettings {
    double step_s = 0.1;     ///< between nodes of the trajectory
    double longest_s = 60;   ///< of a take; the rest of it is left out
    double shortest_s = 15;  ///< of movement, of all takes
    int most_iterations = 12;

    double sigma_rest_rad = radians(2);     ///< each joint in the rest pose
    double sigma_level_rad = radians(1.5);  ///< the hips in the rest pose
    double sigma_mounting_rad = radians(3), sigma_place_m = 0.005;
    double sigma_source_m = 0.004, sigma_offset_m = 0.001, sigma_bone = 0.02, sigma_sound = 0.004;
    double sigma_gyro_zero_rad_per_s = 0.005, sigma_gyro_drift_rad_per_s2 = 1e-4;
    double sigma_accel_zero_m_per_s2 = 0.04;

    /// By which joints seem to turn otherwise than their freedoms allow: their own give, and what of the
    /// flesh under the boards above and below is not solved for. Half as much makes every mounting err by a
    /// quarter more on realistic performers, and its sigma too small.
    double sigma_give_rad = radians(6);
    /// Of soft tissue, per unit of a feature (half the sine of a joint's turn).
    double sigma_tilt_rad = 0.04, sigma_shift_m = 0.009;
    double sigma_twist_lag = 0.1;  ///< share of its segment's axial turn that a board misses
    bool flesh = true;             ///< solve for how boards move with the pose

    /// Of the turn of a board in a step: of all, and as a share of it, which tissue moves on its own.
    double sigma_turn_rad = 5e-4, turn_share = 0.015;

    /// Errors of readings and joints (wobble, tissue, give) stay alike for so long: a tenfold rate of
    /// readings tells no more about a constant.
    double correlation_s = 0.5;
};

}  // namespace noctule
