// SPDX-License-Identifier: Apache-2.0
// Offset and rate of each box's clock against suit 1, from flights of sound between suits in both directions
// (take format, several suits, section 2). A flight is measured as arrival minus emission, each on its own
// suit's clock. The two directions of a pair of housings share one way, a cubic of time within a window
// of 0.4 s, and differ by the clocks. Seconds throughout.
#pragma once

#include <vector>

#include "core/math/conventions.h"

namespace noctule::cooperative {

/// Sound from a source in one suit to a microphone in another; both belong to housings that carry a source
/// and a microphone each.
struct TimedFlight {
    int from_suit = 0, to_suit = 0;        ///< indices of suits
    int from_housing = 0, to_housing = 0;  ///< within their suits
    double emission_s = 0, arrival_s = 0;  ///< each on its own suit's clock, delays of the parts taken off
    double sigma_s = 1e-5;
};

struct ClockGuess {
    double offset_s = 0, rate = 1;  ///< take time = offset + rate * suit time
    bool stands_still = false;      ///< the room: its end of a way does not move
};

struct ClockSettings {
    double window_s = 0.4;
    double offset_wander_s = 0.5e-6;  ///< per sqrt(s); larger: older windows count less
    double rate_wander = 0.01e-6;     ///< per sqrt(s); larger: the rate follows faster and is less certain
    double guess_sigma_s = 0.01, guess_rate_sigma = 50e-6;
    /// Two people who move along with their line make sound's way longer in one direction than the other. In
    /// units of the speed of sound: 0.5 m/s that lasts for a second, as if drawn anew in each window. Within
    /// a window it is a line of time; the same bound holds for what it changes by in half a window.
    double drift_of_pair = 0.85 / 344;
    double drift_of_housings = 0.3 / 344;  ///< the same, of one pair of housings against its bodies
    /// Microphone and source of a housing are 10 mm apart: half of that, along a line of sight in any
    /// direction (1 / sqrt 3). The housings of a suit often point alike and turn with their wearer, so it
    /// averages neither over pairs nor over time; it is added to the stated sigma.
    double housing_s = 2.9e-3 / 344;
};

struct ClockPoint {
    double suit_s = 0, offset_s = 0;  ///< at suit time suit_s, take time = suit_s + offset_s
    double rate = 1;                  ///< d take time / d suit time
    double sigma_s = 0;               ///< of the offset
};

struct ClockTrack {
    /// False: no flights in both directions lead to suit 1, points are empty.
    bool joined = false;
    std::vector<ClockPoint> points;  ///< one per window, smoothed over the whole take
};

/// One track per guess; the first suit is the reference, with offset 0 and rate 1.
std::vector<ClockTrack> estimateClocks(const std::vector<TimedFlight>& flights,
                                       const std::vector<ClockGuess>& guesses,
                                       const ClockSettings& settings = {});

/// Take time of an instant of a suit, linear between points and beyond the ends.
double takeTime_s(const ClockTrack& track, double suit_s);

}  // namespace noctule::cooperative
