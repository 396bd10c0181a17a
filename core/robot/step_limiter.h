// SPDX-License-Identifier: Apache-2.0
// Keeps one joint's commands inside its limits of place, speed, acceleration and jerk, at equal steps of
// time. Each step offers the interval of next places from which the joint can still stop in time; a wish
// inside it is met, one outside is met at its border. Speed and acceleration are differences of commands.
#pragma once

namespace noctule::robot {

/// rad (or m) and seconds. An infinite acceleration or jerk limits nothing.
struct JointLimits {
    double lower = 0, upper = 0;
    double speed = 1, acceleration = 20, jerk = 400;
};

struct JointMotion {
    double place = 0, speed = 0, acceleration = 0;
};

struct MotionRange {
    double from = 0, to = 0;

    double nearest(double value) const { return value < from ? from : value > to ? to : value; }
};

class StepLimiter {
public:
    StepLimiter(const JointLimits& limits, double dt_s) : limits_(limits), dt_s_(dt_s) {}

    /// Places that may be commanded next.
    MotionRange reachable(const JointMotion& now) const;
    /// The command nearest to the wish that does not overshoot it: the joint slows down before it arrives.
    /// `wish_speed`: how fast the wish itself moves.
    double approach(const JointMotion& now, double wish, double wish_speed) const;
    /// The motion after the command.
    JointMotion after(const JointMotion& now, double command) const;
    /// As fast as the limits allow to a standstill.
    double brake(const JointMotion& now) const { return approach(now, now.place, 0); }

private:
    MotionRange accelerations(const JointMotion& now) const;
    double highest(const JointMotion& now, double upper, double frame_speed, const MotionRange& range) const;

    JointLimits limits_;
    double dt_s_;
};

/// How far a joint moves on while it brakes at full jerk and acceleration from a speed and acceleration.
double stoppingDistance(double speed, double acceleration, const JointLimits& limits);

}  // namespace noctule::robot
