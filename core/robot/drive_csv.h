// SPDX-License-Identifier: Apache-2.0
// Commands of a drive and the robot's states beside them as CSV, a row per command (devices/robot/README.md).
// Seconds count from the first command on one clock.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace noctule::robot {

struct DriveCsvRow {
    double time_s = 0;
    std::optional<double> pose_arrived_s = {},
                          pose_time_s = {};  ///< when its data came; the suit's or take's own time
    int64_t sequence = 0;
    std::string state, trouble;  ///< trouble empty: none
    std::optional<double> robot_arrived_s = {};
    std::optional<int64_t> robot_sequence = {};  ///< the newest command that the robot had heard
    const std::vector<double>& command;
    const std::vector<double>* actual = nullptr;  ///< null: the robot has not told yet
};

/// The first line.
std::string driveCsvHead(const std::vector<std::string>& joints);
void appendDriveCsv(const DriveCsvRow& row, std::string& text);

}  // namespace noctule::robot
