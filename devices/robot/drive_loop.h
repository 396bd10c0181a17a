// SPDX-License-Identifier: Apache-2.0
// The loop that drives a robot: equal steps in real time, each one takes the newest pose and the robot's
// newest state, decides (core/robot/live_drive) and sends one command. Waits; belongs into a job.
#pragma once

#include <functional>
#include <string>

#include "core/job/job.h"
#include "devices/robot/pose_feed.h"
#include "devices/robot/robot_interface.h"

namespace noctule::robot_link {

/// One step of the loop, while it lasts.
struct DriveMoment {
    int64_t start_ns = 0, now_ns = 0;  ///< of the first step and of this one (std::chrono::steady_clock)
    const robot::DriveInput& input;
    const robot::DriveOutput& output;
    int64_t pose_time_ns = 0;  ///< of the take or the suit
    const LinkStatus& link;
    uint64_t sequence = 0;  ///< of the command
};

/// Of `state`, as tables and files say it: "following".
const char* stateName(robot::TeleopState state);

struct DrivePlan {
    RobotInterface& link;
    const PoseFeed& feed;
    const robot::RobotModel& model;
    const robot::RobotProfile& profile;
    const robot::DrivenParts& parts;
    std::array<double, 2> human_length_m;
    robot::DriveSettings settings;
    std::optional<double> seconds;  ///< none: until `ends` or cancelled
    /// What the operator presses, asked for once per command.
    std::function<robot::TeleopKeys(const robot::DriveOutput&)> keys;
    std::function<bool()> ends;                       ///< the source of poses has come to its end
    std::function<void(const std::string&)> tell;     ///< every change of state or trouble, a sentence
    bool keeps_rows = false;                          ///< for `table`
    std::function<void(const DriveMoment&)> watch{};  ///< every step, on the loop's thread; quick
    bool is_open = false;                             ///< awaitRobot() was called on the link
};

struct DriveReport {
    int64_t commands = 0, skipped = 0;  ///< skipped: steps that came too late to be sent
    int64_t following = 0;              ///< commands while following
    double largest_speed_use = 0;       ///< of a joint's limit; at most 1
    double longest_hold_s = 0;          ///< from the last fresh pose or state to the last command that moved
    double silent_s = 0;                ///< from the robot's last state to the end
    bool cancelled = false;
    LinkStatus link;
    std::string table;  ///< CSV, README.md
};

/// Opens the link and waits until the robot tells where it stands. kDevice: it does not within 5 s.
Status awaitRobot(RobotInterface& link, const JobContext& job);

/// kDevice: the robot tells no state within 5 s.
Result<DriveReport> runDrive(const DrivePlan& plan, const JobContext& job);

}  // namespace noctule::robot_link
