// SPDX-License-Identifier: Apache-2.0
// How fast a turntable really turned. Its axis never stands quite upright, so gravity swings in the boards'
// horizontal axes once a turn: in the world it stays where it is. Each board's gyroscope, calibrated for the
// nominal speed, follows its heading through the take; a table that is faster by a part e makes gravity seem
// to turn back by e of the heading, over all turns together. Needs no calibrated accelerometer: what is
// constant in the board's frame, zero and centrifugal force, falls out.
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/steady_stretches.h"

namespace noctule {

/// A board with the gyroscope that belongs to the nominal speed.
struct HeadingBoard {
    const BoardRecord* record = nullptr;
    std::vector<SteadyStretch> turns;
    Matrix3d matrix = Matrix3d::Identity();
    std::vector<std::vector<std::pair<double, Vector3d>>> zeros;  ///< per take: time in s, counts; in order
};

struct SpeedRatio {
    double excess = 0;  ///< true speed / nominal speed - 1
    double sigma = 0;
    double swing_m_per_s2 = 0;  ///< amplitude of the ripple
    int boards = 0;
};

/// None when no board shows the ripple.
std::optional<SpeedRatio> turntableSpeed(const std::vector<HeadingBoard>& boards);

}  // namespace noctule
