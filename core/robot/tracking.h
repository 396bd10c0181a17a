// SPDX-License-Identifier: Apache-2.0
// How a robot follows its commands: the delay at which the achieved path lies best on the commanded one, and
// what then remains (Miller 2004, figure 9). Seconds and metres, both paths on one clock and in one frame.
#pragma once

#include <optional>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::robot {

struct PathPoint {
    double time_s = 0;
    Vector3d p_m = Vector3d::Zero();
};

/// Achieved against commanded.
struct Tracking {
    double delay_s = 0;                     ///< achieved after commanded
    double apart_rms_m = 0;                 ///< at one instant
    double rest_rms_m = 0, rest_max_m = 0;  ///< after the delay is taken off
    int points = 0;                         ///< of the achieved path that were compared
};

/// Below, the commands move too little to tell a delay.
inline constexpr double kLeastWay_m = 0.02;

/// Times increase in each path; commands between two points lie on the line that joins them. Achieved points
/// that are nearer than `longest_delay_s` to the first command are left out. Nothing when fewer than ten
/// points remain or the commands stay within kLeastWay_m.
std::optional<Tracking> trackingOf(const std::vector<PathPoint>& commanded,
                                   const std::vector<PathPoint>& achieved, double longest_delay_s = 0.5);

}  // namespace noctule::robot
