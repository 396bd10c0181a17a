// SPDX-License-Identifier: Apache-2.0
#include "core/robot/drive_csv.h"

#include <cstdio>

#include "core/job/csv_cell.h"

namespace noctule::robot {
namespace {

void appendNumber(const std::optional<double>& value, std::string& text) {
    if (!value) {
        text += ",";
        return;
    }
    char number[48];
    std::snprintf(number, sizeof number, ",%.6f", *value);
    text += number;
}

}  // namespace

std::string driveCsvHead(const std::vector<std::string>& joints) {
    std::string text =
        "time_s,pose_arrived_s,pose_time_s,sequence,state,trouble,robot_arrived_s,robot_sequence";
    for (const char* what : {"command ", "actual "})
        for (const std::string& joint : joints)
            text += "," + csvCell(what + joint);
    return text + "\n";
}

void appendDriveCsv(const DriveCsvRow& row, std::string& text) {
    char time[48];
    std::snprintf(time, sizeof time, "%.6f", row.time_s);
    text += time;
    appendNumber(row.pose_arrived_s, text);
    appendNumber(row.pose_time_s, text);
    text += "," + std::to_string(row.sequence) + "," + row.state + "," + row.trouble;
    appendNumber(row.robot_arrived_s, text);
    text += "," + (row.robot_sequence ? std::to_string(*row.robot_sequence) : std::string());
    for (const double q : row.command)
        appendNumber(q, text);
    for (size_t i = 0; i < row.command.size(); ++i)
        appendNumber(row.actual ? std::optional((*row.actual)[i]) : std::nullopt, text);
    text += "\n";
}

}  // namespace noctule::robot
