// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/box_clock.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/random.h"

namespace noctule::simulation {
namespace {

constexpr double kClockStep_s = 0.1;

}  // namespace

BoxClock::BoxClock(const CastScenario& scenario, double duration_s, uint64_t seed) {
    Random offset(seed, "clock offset"), rate(seed, "clock rate");
    Random phase_walk(seed, "clock wander"), rate_walk(seed, "clock rate wander");
    offset_s_ = offset.uniform(scenario.clock_offset_s[0], scenario.clock_offset_s[1]);
    rate_ = 1 + rate.uniform(scenario.clock_rate_error[0], scenario.clock_rate_error[1]);
    const auto steps = static_cast<size_t>(std::ceil(duration_s / kClockStep_s)) + 1;
    const double root_step = std::sqrt(kClockStep_s);
    double wander_s = 0, rate_error = 0;
    for (size_t i = 0; i <= steps; ++i) {
        wander_s_.push_back(wander_s);
        wander_s +=
            rate_error * kClockStep_s + phase_walk.gaussian(scenario.clock_wander_s_per_sqrt_s * root_step);
        rate_error += rate_walk.gaussian(scenario.clock_rate_wander_per_sqrt_s * root_step);
    }
}

BoxClock BoxClock::startedAt(double suit_s) const {
    BoxClock later = *this;
    later.start_s_ += suit_s;
    return later;
}

double BoxClock::wander_s(double suit_s) const {
    if (wander_s_.empty())
        return 0;
    const double last = static_cast<double>(wander_s_.size() - 1);
    const double place = std::clamp(suit_s / kClockStep_s, 0.0, last);
    const auto i = std::min(static_cast<size_t>(place), wander_s_.size() - 2);
    const double fraction = place - static_cast<double>(i);
    return (1 - fraction) * wander_s_[i] + fraction * wander_s_[i + 1];
}

double BoxClock::takeTime_s(double suit_s) const {
    if (isTakeTime())
        return suit_s;
    const double counted_s = suit_s + start_s_;
    return offset_s_ + rate_ * counted_s + wander_s(counted_s);
}

double BoxClock::suitTime_s(double take_s) const {
    if (isTakeTime())
        return take_s;
    double counted_s = (take_s - offset_s_) / rate_;
    for (int round = 0; round < 3; ++round)  // each shrinks the error by the wander's slope, below 1e-4
        counted_s = (take_s - offset_s_ - wander_s(counted_s)) / rate_;
    return counted_s - start_s_;
}

SuitClock firstGuess(const BoxClock& clock, const CastScenario& scenario, uint64_t seed) {
    if (clock.isTakeTime())
        return {};
    const double error_s = Random(seed, "first guess of the clock")
                               .uniform(scenario.first_guess_error_s[0], scenario.first_guess_error_s[1]);
    return {(clock.takeTime_s(0) + error_s) * 1e9, 1};
}

}  // namespace noctule::simulation
