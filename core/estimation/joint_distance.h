// SPDX-License-Identifier: Apache-2.0
// Ranges between the suits of one take: from a source of a performer or of the room to a microphone of
// another one or of the room.
#pragma once

#include <cstdint>
#include <vector>

#include "core/acoustics/range.h"
#include "core/estimation/suit_model.h"

namespace noctule {

/// time = offset_s + rate * suit time; the common time of all suits.
struct ClockLine {
    double offset_s = 0, rate = 1;

    double common_s(double suit_s) const { return offset_s + rate * suit_s; }
    double suit_s(double common_s) const { return (common_s - offset_s) / rate; }
};

/// Members are the bodies in their order, and one past the last body: the room.
struct JointDistance {
    int from = 0, to = 0;  ///< members; never the same
    int source = 0, board = 0;
    double emission_s = 0, arrival_s = 0;  ///< each on its own suit's clock
    double c_m_per_s = 344;
    double beyond_m = 0;  ///< the distance is c times the flight on common time, plus this
    double sigma_m = 0;   ///< at full confidence
    double confidence = 1;

    double distance_m(const std::vector<ClockLine>& clocks) const {
        return beyond_m + c_m_per_s * (clocks[static_cast<size_t>(to)].common_s(arrival_s) -
                                       clocks[static_cast<size_t>(from)].common_s(emission_s));
    }
};

struct JointDecision {
    size_t distance = 0;  ///< its index
    RangeFate fate = RangeFate::kNotTried;
    double w_a = 1;
    double innovation_m = 0;
};

}  // namespace noctule
