// SPDX-License-Identifier: Apache-2.0
// The sample clock of one box against the clock of the take, which is that of suit 1:
// take time = offset + rate * suit time + wander(suit time). Truth; a recorder only guesses it. Seconds.
#pragma once

#include <cstdint>
#include <vector>

#include "core/recording/rows.h"
#include "core/simulation/cast_scenario.h"

namespace noctule::simulation {

class BoxClock {
public:
    /// Take time itself.
    BoxClock() = default;
    /// Drawn for a take of that length; beyond it the wander stays what it is at the end.
    BoxClock(const CastScenario& scenario, double duration_s, uint64_t seed);

    /// The same clock of a box that begins to count when this one shows `suit_s`.
    BoxClock startedAt(double suit_s) const;

    bool isTakeTime() const { return wander_s_.empty() && start_s_ == 0; }
    double takeTime_s(double suit_s) const;
    double suitTime_s(double take_s) const;
    double offset_s() const { return offset_s_; }  ///< without the wander
    double rate() const { return rate_; }

private:
    double wander_s(double suit_s) const;

    double offset_s_ = 0, rate_ = 1, start_s_ = 0;
    std::vector<double> wander_s_;  ///< at steps of kStep_s from suit time 0 on, linear between them
};

/// What a recorder takes for the clock at the take's beginning, by its network's time.
SuitClock firstGuess(const BoxClock& clock, const CastScenario& scenario, uint64_t seed);

}  // namespace noctule::simulation
