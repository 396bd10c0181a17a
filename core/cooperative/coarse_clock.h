// SPDX-License-Identifier: Apache-2.0
// The clocks of two boxes to a fraction of a millisecond, from the sound that each heard of the other, before
// it is known which arrival belongs to which pulse. The recorder's guess is up to 10 ms off, a pulse interval
// is 8 ms and pulses do not tell their numbers. Two things do: between arrivals of all sources there is a
// pause in every interval; and only when both directions are counted right, their half difference is the same
// for every pair of housings.
#pragma once

#include <optional>
#include <vector>

namespace noctule::cooperative {

/// One arrival, seen from some pulse that may not be its own.
struct LooseArrival {
    int pulse = 0;  ///< index into Direction::sources
    int board = 0;
    double delay_s = 0;  ///< from that pulse to the arrival, both on take time by the recorder's guesses;
                         ///< less than an interval
};

/// What the boards of one suit heard of the other's sources in a short stretch, a second or so.
struct Direction {
    double interval_s = 0;        ///< between pulses
    std::vector<int> sources;     ///< of the pulses, in their order
    std::vector<int> board_near;  ///< by source: the board of its own suit in the same housing or on the same
                                  ///< segment; -1: none
    std::vector<LooseArrival> arrivals;
};

struct CoarseClock {
    double ahead_s = 0;  ///< how much later the second's guessed take time is than the first's
    int there_pulses =
        0;  ///< an arrival at the second belongs to the pulse so many before the one it was given to
    int back_pulses = 0;
    double way_s = 0;     ///< median of the sound's ways
    double spread_s = 0;  ///< median absolute deviation between pairs of housings
};

/// `there`: sources of the first, boards of the second. Nothing when fewer than three pairs of housings hear
/// each other both ways, or no counting makes them agree within 1 ms.
std::optional<CoarseClock> coarseClock(const Direction& there, const Direction& back);

}  // namespace noctule::cooperative
