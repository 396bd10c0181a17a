// SPDX-License-Identifier: Apache-2.0
// A drive of a robot as it stands in a take: read back, summed up, and as files: CSV, a JointTrajectory of
// ROS, a page with the hands commanded against achieved.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/recording/take.h"
#include "core/robot/robot_report.h"

namespace noctule {

struct RecordedDrive {
    RobotDriveRow about;
    std::vector<RobotCommandRow> commands;
    std::vector<RobotStateRow> states;
};

/// `drive` 0: the last one. kUnusable: the take has none, or not this one.
Result<RecordedDrive> readRecordedDrive(const Take& take, int64_t drive = 0);

struct DriveSummary {
    RobotDriveRow about;
    int64_t commands = 0, following = 0, states = 0;
    int64_t missing = 0;                                   ///< numbers left out between commands
    double duration_s = 0;                                 ///< from the first command to the last
    std::optional<double> pose_to_command_ms = {};         ///< median, of commands with a new pose
    std::vector<std::optional<robot::Tracking>> tracking;  ///< per arm; none: it hardly moved
};
DriveSummary summaryOf(const RecordedDrive& drive);
nlohmann::json toJson(const DriveSummary& summary);
/// "arm led by the take: 1400 commands, ..."; one line without its end.
std::string summaryText(const DriveSummary& summary);

/// Per arm: commanded and achieved, on the clock of the rows.
std::vector<robot::HandPair> handsOf(const RecordedDrive& drive);
/// As the verb `drive` writes it (devices/robot/README.md).
std::string driveCsv(const RecordedDrive& drive);
/// Commands as points with their times from the first one.
nlohmann::json driveTrajectory(const RecordedDrive& drive);
std::string driveReportHtml(const RecordedDrive& drive);

}  // namespace noctule
