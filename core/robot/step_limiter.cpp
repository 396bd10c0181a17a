// SPDX-License-Identifier: Apache-2.0
#include "core/robot/step_limiter.h"

#include <algorithm>
#include <cmath>

namespace noctule::robot {
namespace {

/// Halvings of the interval of accelerations: its 65,000th part is left unused at most.
constexpr int kHalvings = 16;

/// From a standstill of the acceleration: down at full jerk, on at full acceleration, back to 0.
double stoppingFromSteady(double speed, const JointLimits& limits) {
    if (speed <= 0)
        return 0;
    if (std::isinf(limits.jerk))
        return speed * speed / (2 * limits.acceleration);
    const double ramp = limits.acceleration * limits.acceleration / limits.jerk;
    const double time_s = speed <= ramp ? 2 * std::sqrt(speed / limits.jerk)
                                        : speed / limits.acceleration + limits.acceleration / limits.jerk;
    return speed * time_s / 2;
}

JointMotion mirrored(const JointMotion& motion) {
    return {-motion.place, -motion.speed, -motion.acceleration};
}

}  // namespace

double stoppingDistance(double speed, double acceleration, const JointLimits& limits) {
    if (std::isinf(limits.acceleration))
        return 0;
    if (std::isinf(limits.jerk))
        return stoppingFromSteady(speed, limits);
    const double J = limits.jerk, a = acceleration;
    if (a >= 0) {
        const double time_s = a / J, steady = speed + a * a / (2 * J);
        const double before = speed * time_s + a * a * a / (3 * J * J);
        return steady > 0 ? std::max(0.0, before + stoppingFromSteady(steady, limits)) : 0;
    }
    if (speed <= 0)
        return 0;
    if (speed >= a * a / (2 * J)) {  // on its way down already: what is left of a whole stop
        const double time_s = -a / J, begin = speed + a * a / (2 * J);
        return stoppingFromSteady(begin, limits) - (begin * time_s - J * time_s * time_s * time_s / 6);
    }
    const double time_s = (-a - std::sqrt(a * a - 2 * J * speed)) / J;
    return speed * time_s + a * time_s * time_s / 2 + J * time_s * time_s * time_s / 6;
}

MotionRange StepLimiter::accelerations(const JointMotion& now) const {
    const double change = limits_.jerk * dt_s_;
    return {std::max(-limits_.acceleration, now.acceleration - change),
            std::min(limits_.acceleration, now.acceleration + change)};
}

/// Of the accelerations the largest from which a stop below `upper` is possible, in a frame that moves at
/// `frame_speed`; `upper` is a place at the next step. The smallest when none is.
double StepLimiter::highest(const JointMotion& now, double upper, double frame_speed,
                            const MotionRange& range) const {
    const auto fits = [&](double acceleration) {
        const double speed = now.speed + acceleration * dt_s_;
        const double peak = speed + (acceleration > 0 && !std::isinf(limits_.jerk)
                                         ? acceleration * acceleration / (2 * limits_.jerk)
                                         : 0);
        const double left = upper - (now.place + speed * dt_s_);
        return peak <= limits_.speed && stoppingDistance(speed - frame_speed, acceleration, limits_) <= left;
    };
    if (fits(range.to))
        return range.to;
    double good = range.from, bad = range.to;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (good + bad) / 2;
        (fits(middle) ? good : bad) = middle;
    }
    return good;
}

MotionRange StepLimiter::reachable(const JointMotion& now) const {
    if (std::isinf(limits_.acceleration)) {
        const double step = limits_.speed * dt_s_;
        const double from = std::max(limits_.lower, now.place - step);
        return {from, std::max(from, std::min(limits_.upper, now.place + step))};
    }
    const MotionRange range = accelerations(now);
    const double up = highest(now, limits_.upper, 0, range);
    const double down = -highest(mirrored(now), -limits_.lower, 0, {-range.to, -range.from});
    const auto placeAfter = [&](double acceleration) {
        return now.place + (now.speed + acceleration * dt_s_) * dt_s_;
    };
    return {placeAfter(std::min(up, down)), placeAfter(up)};
}

double StepLimiter::approach(const JointMotion& now, double wish, double wish_speed) const {
    const MotionRange can = reachable(now);
    if (std::isinf(limits_.acceleration))
        return can.nearest(wish);
    const MotionRange range = accelerations(now);
    const double relative = now.speed - wish_speed;
    const bool rises = relative > 0 || (relative == 0 && now.acceleration > 0);
    const double stop = now.place + (rises ? stoppingDistance(relative, now.acceleration, limits_)
                                           : -stoppingDistance(-relative, -now.acceleration, limits_));
    const double acceleration = stop <= wish - wish_speed * dt_s_
                                    ? highest(now, wish, wish_speed, range)
                                    : -highest(mirrored(now), -wish, -wish_speed, {-range.to, -range.from});
    return can.nearest(now.place + (now.speed + acceleration * dt_s_) * dt_s_);
}

JointMotion StepLimiter::after(const JointMotion& now, double command) const {
    const double speed = (command - now.place) / dt_s_;
    return {command, speed, (speed - now.speed) / dt_s_};
}

}  // namespace noctule::robot
