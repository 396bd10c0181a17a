// SPDX-License-Identifier: Apache-2.0
// The clocks of two boxes to a fraction of a millisecond, from the sound that each heard of the other, before
// it is known which arrival belongs to which pulse. The recorder's guess is up to 10 ms off, a pulse interval
// is 8 ms and pulses do not tell their numbers. But the sources sound in turn, and where they are to each
// other is known: counted right, the delays to one board fit a single place of that board, counted wrong they
// do not.
#pragma once

#include <optional>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::cooperative {

/// Until a thermometer is asked; temperature changes it by 1 % in 6 degrees.
inline constexpr double kSupposedSound_m_per_s = 344;

/// One arrival, seen from some pulse that may not be its own.
struct LooseArrival {
    int pulse = 0;  ///< index into Direction::sources
    int board = 0;
    double delay_s = 0;  ///< from that pulse to the arrival, both on take time by the recorder's guesses;
                         ///< less than an interval
};

/// What the boards of one suit heard of the other's sources in a short stretch, a second or so.
struct Direction {
    double interval_s = 0;     ///< between pulses
    std::vector<int> sources;  ///< of the pulses, in their order
    std::vector<Vector3d>
        places_m;  ///< of the sources, in one frame: of a body in its standing pose, or of a room
    std::vector<Vector3d> boards_m;  ///< the same of the boards
    bool from_room = false;          ///< the sources are anchors
    std::vector<int> board_near;  ///< by source: the board of its own suit in the same housing or on the same
                                  ///< segment; -1: none
    std::vector<LooseArrival> arrivals;
};

struct CoarseClock {
    double ahead_s = 0;  ///< how much later the second's guessed take time is than the first's
    /// How long sound takes: sources of the first x boards of the second, and back.
    Eigen::MatrixXd there_s, back_s;
    double spread_s = 0;  ///< median absolute deviation between pairs of housings, or of arrivals in a room
};

/// `there`: sources of the first, boards of the second. Bodies stand about as in `places_m`, or what was
/// found a few seconds before, or is known otherwise, is given as `before`. Nothing when too few of them hear
/// each other, or no counting fits much better than all others.
std::optional<CoarseClock> coarseClock(const Direction& there, const Direction& back,
                                       const std::optional<CoarseClock>& before = std::nullopt);

}  // namespace noctule::cooperative
