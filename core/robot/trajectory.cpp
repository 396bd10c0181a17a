// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/robot/motion_mapping.h"

namespace noctule::robot {
namespace {

constexpr double kLongestLoop_s = 60;
constexpr double kRounding = 1e-6;  ///< of differences of commands, as a part of a limit

/// Place, speed and acceleration, per step of the bridge taken as 1.
struct BridgeEnd {
    double place = 0, speed = 0, acceleration = 0;
};

/// The fifth-order polynomial over 0..1 that meets both ends.
double quintic(double t, const BridgeEnd& from, const BridgeEnd& to) {
    const double way = to.place - from.place;
    const double c3 =
        10 * way - 6 * from.speed - 4 * to.speed - 1.5 * from.acceleration + 0.5 * to.acceleration;
    const double c4 = -15 * way + 8 * from.speed + 7 * to.speed + 1.5 * from.acceleration - to.acceleration;
    const double c5 =
        6 * way - 3 * from.speed - 3 * to.speed - 0.5 * from.acceleration + 0.5 * to.acceleration;
    return from.place + t * (from.speed + t * (from.acceleration / 2 + t * (c3 + t * (c4 + t * c5))));
}

/// Frames strictly between the last and the first one. Accelerations are met where jerk is limited.
std::vector<std::vector<double>> bridge(const RobotTrajectory& trajectory,
                                        const std::vector<CommandLimits>& limits, size_t steps) {
    const auto& f = trajectory.frames;
    const size_t last = f.size() - 1;
    const auto unit = static_cast<double>(steps);
    std::vector<std::vector<double>> rows(steps - 1, std::vector<double>(trajectory.joints.size()));
    for (size_t j = 0; j < trajectory.joints.size(); ++j) {
        const double square = limits[j].jerk > 0 ? unit * unit : 0;
        const BridgeEnd from{f[last][j], (f[last][j] - f[last - 1][j]) * unit,
                             (f[last][j] - 2 * f[last - 1][j] + f[last - 2][j]) * square};
        const BridgeEnd to{f[0][j], (f[1][j] - f[0][j]) * unit, (f[2][j] - 2 * f[1][j] + f[0][j]) * square};
        for (size_t i = 1; i < steps; ++i)
            rows[i - 1][j] = quintic(static_cast<double>(i) / unit, from, to);
    }
    return rows;
}

}  // namespace

Result<std::vector<CommandLimits>> limitsOf(const RobotModel& model, const RobotProfile& profile,
                                            const RobotTrajectory& trajectory) {
    std::vector<CommandLimits> limits;
    for (const std::string& name : trajectory.joints) {
        const int index = model.findJoint(name);
        if (index < 0)
            return Error{ErrorKind::kUnusable, "the robot has no joint \"" + name + "\"",
                         "Take the URDF that the commands were made for"};
        const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
        CommandLimits one{joint.lower, joint.upper, usableSpeed(joint.max_speed), profile.max_acceleration,
                          profile.max_acceleration > 0 ? profile.max_jerk : 0};
        for (const auto* limbs : {&profile.arms, &profile.legs})
            for (const ArmProfile& limb : *limbs)
                if (const auto chain = Chain::make(model, limb.base, limb.tip);
                    chain && chain->find(name) >= 0)
                    one.speed = limb.max_speed[static_cast<size_t>(chain->find(name))];
        limits.push_back(one);
    }
    return limits;
}

LimitUse limitUse(const RobotTrajectory& trajectory, const std::vector<CommandLimits>& limits) {
    LimitUse use;
    double largest = 0;
    for (size_t j = 0; j < limits.size(); ++j) {
        const CommandLimits& limit = limits[j];
        double speed = 0, acceleration = 0;
        for (size_t i = 0; i < trajectory.frames.size(); ++i) {
            const double place = trajectory.frames[i][j];
            const bool is_inside = place >= limit.lower - 1e-9 && place <= limit.upper + 1e-9;
            LimitUse here{is_inside ? 1.0 : 2.0, 0, 0, 0, ""};
            if (i > 0) {
                const double dt_s = trajectory.frame_time_s;
                const double next_speed = (place - trajectory.frames[i - 1][j]) / dt_s;
                const double next_acceleration = (next_speed - speed) / dt_s;
                here.speed = std::abs(next_speed) / limit.speed;
                here.acceleration =
                    limit.acceleration > 0 ? std::abs(next_acceleration) / limit.acceleration : 0;
                here.jerk =
                    limit.jerk > 0 ? std::abs(next_acceleration - acceleration) / dt_s / limit.jerk : 0;
                speed = next_speed;
                acceleration = next_acceleration;
            }
            use.place = std::max(use.place, here.place);
            use.speed = std::max(use.speed, here.speed);
            use.acceleration = std::max(use.acceleration, here.acceleration);
            use.jerk = std::max(use.jerk, here.jerk);
            const double most = std::max({here.place, here.speed, here.acceleration, here.jerk});
            if (most > largest) {
                largest = most;
                use.joint = trajectory.joints[j];
            }
        }
    }
    return use;
}

Status closeLoop(RobotTrajectory& trajectory, const std::vector<CommandLimits>& limits, double shortest_s) {
    const size_t count = trajectory.frames.size();
    if (count < 3)
        return Error{ErrorKind::kUnusable, "the commands have fewer than three frames",
                     "Take a longer motion, or leave the loop out"};
    for (double duration_s = shortest_s; duration_s <= kLongestLoop_s; duration_s *= 1.25) {
        const auto steps = static_cast<size_t>(std::ceil(duration_s / trajectory.frame_time_s));
        const auto rows = bridge(trajectory, limits, std::max<size_t>(2, steps));
        RobotTrajectory judged;
        judged.frame_time_s = trajectory.frame_time_s;
        judged.joints = trajectory.joints;
        judged.frames = trajectory.frames;
        judged.frames.insert(judged.frames.end(), rows.begin(), rows.end());
        for (size_t i = 0; i < 3; ++i)  // and on into the beginning
            judged.frames.push_back(trajectory.frames[i]);
        const LimitUse use = limitUse(judged, limits);
        if (use.place > 1 || std::max({use.speed, use.acceleration, use.jerk}) > 1 + kRounding)
            continue;
        trajectory.loop_start_s = {static_cast<double>(count) * trajectory.frame_time_s};
        trajectory.frames.insert(trajectory.frames.end(), rows.begin(), rows.end());
        return Done{};
    }
    return Error{ErrorKind::kUnusable, "the motion cannot be closed to a loop within the robot's limits",
                 "Let the motion begin and end in about one posture, and at rest"};
}

}  // namespace noctule::robot
