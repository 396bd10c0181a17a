// SPDX-License-Identifier: Apache-2.0
// Three seconds of standing still before a take: does the calibration in force still hold? The rest pose is
// fitted as in the rest pose calibration, with boards held to their calibrated places, so that a performer
// who stands a little differently moves the pose and a strap that slipped moves one board. A turn about the
// vertical shows only where it moves the microphone. Angles in radians, distances in metres; a take that
// cannot be checked is a report with reasons.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/findings.h"
#include "core/calibration/observations.h"

namespace noctule {

struct BoardStillCheck {
    std::string id;
    bool heard = false;                                 ///< else none of the following holds
    double tilt_change_rad = 0;                         ///< against calibration and pose
    Vector3d gyro_change_rad_per_s = Vector3d::Zero();  ///< of the zeros
    double range_residual_m = 0;                        ///< median size over the sources that it hears
    int ranges = 0;
    bool slipped = false;
};

struct PairStillCheck {
    int source = 0, board = 0;
    double residual_m = 0;  ///< measured minus expected
};

struct StillCheckReport {
    std::vector<Finding> findings;        ///< none: good
    std::string unchecked;                ///< "gyroscopes are not calibrated": why nothing was compared
    Stretch stretch;                      ///< that was used
    std::vector<BoardStillCheck> boards;  ///< per board of the suit
    std::vector<PairStillCheck> pairs;

    Grade grade() const { return gradeOf(findings); }
};

StillCheckReport checkStill(const Observations& take);

}  // namespace noctule
