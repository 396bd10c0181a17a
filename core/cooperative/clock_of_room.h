// SPDX-License-Identifier: Apache-2.0
// The clock between a performer's box and a room's. Anchors have known places and a standing body a known
// shape, so place and turn on the floor and the clock are four unknowns. An anchor may be further away than
// sound comes in a pulse interval: every arrival may belong to several pulses, and the one that fits best
// counts.
#pragma once

#include <array>
#include <optional>

#include "core/cooperative/coarse_clock.h"

namespace noctule::cooperative {

struct StandingInRoom {
    double ahead_s = 0;   ///< how much later the second's guessed take time is than the first's
    double misfit_s = 0;  ///< median absolute error of all arrivals
    double share = 0;     ///< of the arrivals that fit; one that misses by 0.2 m counts half
    std::array<Eigen::MatrixXd, 2> ways_s{};  ///< there and back, source x board: how long sound takes
};

/// `there`: sources of the first, boards of the second; one of the two is the room. Nothing when too few
/// arrivals fit one place, or two clocks fit about as well. Four equal anchors in a square that sound in turn
/// look the same from four sides, each a pulse interval further: then those that hear the body tell, or the
/// recorder's guess, which is 5 ms off at most. Unless the clock is known, 85 % of the arrivals must fit.
/// `expected_s`: the clock is known to `within_s`.
std::optional<StandingInRoom> standInRoom(const Direction& there, const Direction& back,
                                          std::optional<double> expected_s, double within_s);

}  // namespace noctule::cooperative
