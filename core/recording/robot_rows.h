// SPDX-License-Identifier: Apache-2.0
// Rows of the tables robot_drive, robot_command and robot_state (README.md, section 3): what a robot was told
// and where it was while a take was recorded or led it. Values in rad, rad/s (prismatic: m, m/s), in the
// order of RobotDriveRow::joints; places in m in the axes of the chest (x left, y up, z ahead). `time_ns`
// counts from the first recorded command on one clock, so delays are differences.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

/// Joints and arms of one drive at most.
inline constexpr size_t kRobotJoints = 64, kRobotArms = 8;
/// Rows of one drive that are read; the rest is skipped: four hours of commands, five of states at 280 a
/// second.
inline constexpr int64_t kMostRobotCommands = 2'000'000, kMostRobotStates = 5'000'000,
                         kMostRobotDrives = 10'000;
/// A joint value beyond this is damage: a turn, 160 times.
inline constexpr double kLargestJointValue = 1000;

struct RobotDriveRow {
    int64_t drive = 0;  ///< counts from 1; given by the take
    std::string created_utc, software;
    std::string robot, address;  ///< as its URDF and the operator call it
    std::string leader;          ///< "suit" or "take"
    double rate_hz = 0;          ///< of commands
    std::vector<std::string> joints, arms;
    std::optional<int64_t> take_time_ns = {};  ///< of time 0 of the rows, to within the suit's least delay
    int64_t lost_rows = 0;                     ///< that could not be written
};

struct RobotCommandRow {
    int64_t sequence = 0;                         ///< counts up by 1
    int64_t time_ns = 0;                          ///< when it was made
    std::optional<int64_t> pose_time_ns = {};     ///< take time of the newest pose
    std::optional<int64_t> pose_arrived_ns = {};  ///< when its data came, on the clock of time_ns
    std::string state, trouble;                   ///< "following"; trouble empty: none
    std::vector<double> q;
    std::vector<Vector3d> tips_m = {};  ///< of the arms, as commanded
};

struct RobotStateRow {
    int64_t time_ns = 0;                          ///< when it came
    std::optional<int64_t> obeyed_sequence = {};  ///< of the newest command that the robot had heard
    bool refuses = false;
    std::vector<double> q, v;
    std::vector<Vector3d> tips_m = {};
};

/// What is written at once, of the drive that began last.
struct RobotRows {
    std::vector<RobotCommandRow> commands;
    std::vector<RobotStateRow> states;
    std::optional<int64_t> take_time_ns = {};  ///< better known now
    int64_t lost_rows = 0;                     ///< so far

    bool empty() const { return commands.empty() && states.empty(); }
    int64_t count() const { return static_cast<int64_t>(commands.size() + states.size()); }
};

}  // namespace noctule
