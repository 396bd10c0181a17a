// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/drive_table.h"

#include <cstdio>

namespace noctule::robot_link {

DriveTable::DriveTable(const std::vector<std::string>& joints) : joints_(joints.size()) {
    text_ = "time_s,pose_arrived_s,pose_time_s,sequence,state,trouble,robot_arrived_s,robot_sequence";
    for (const char* what : {"command ", "actual "})
        for (const std::string& joint : joints)
            text_ += "," + (what + joint);
    text_ += "\n";
}

void DriveTable::number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, ",%.6f", value);
    text_ += text;
}

void DriveTable::add(const DriveMoment& moment) {
    if (++rows_ > kMostRows)
        return;
    const auto seconds = [&](int64_t steady_ns) {
        return static_cast<double>(steady_ns - moment.start_ns) * 1e-9;
    };
    char time[40];
    std::snprintf(time, sizeof time, "%.6f", seconds(moment.now_ns));
    text_ += time;
    if (moment.input.performer) {
        number(seconds(moment.input.performer->arrived_ns));
        number(static_cast<double>(moment.pose_time_ns) * 1e-9);
    } else {
        text_ += ",,";
    }
    text_ += "," + std::to_string(moment.sequence) + "," + stateName(moment.output.state) + "," +
             std::to_string(static_cast<int>(moment.output.trouble));
    if (moment.link.state) {
        number(seconds(moment.link.state_arrived_ns));
        text_ += "," + std::to_string(moment.link.state->obeyed_sequence);
    } else {
        text_ += ",,";
    }
    for (const double q : moment.output.q)
        number(q);
    for (size_t i = 0; i < joints_; ++i)
        if (moment.link.state)
            number(moment.link.state->q[i]);
        else
            text_ += ",";
    text_ += "\n";
}

}  // namespace noctule::robot_link
