// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/drive_table.h"

#include "core/robot/drive_csv.h"

namespace noctule::robot_link {

DriveTable::DriveTable(const std::vector<std::string>& joints) : text_(robot::driveCsvHead(joints)) {}

void DriveTable::add(const DriveMoment& moment) {
    if (++rows_ > kMostRows)
        return;
    const auto seconds = [&](int64_t steady_ns) {
        return static_cast<double>(steady_ns - moment.start_ns) * 1e-9;
    };
    robot::DriveCsvRow row{.time_s = seconds(moment.now_ns),
                           .sequence = static_cast<int64_t>(moment.sequence),
                           .state = stateName(moment.output.state),
                           .trouble = troubleName(moment.output.trouble),
                           .command = moment.output.q};
    if (moment.input.performer) {
        row.pose_arrived_s = seconds(moment.input.performer->arrived_ns);
        row.pose_time_s = static_cast<double>(moment.pose_time_ns) * 1e-9;
    }
    if (moment.link.state) {
        row.robot_arrived_s = seconds(moment.link.state_arrived_ns);
        row.robot_sequence = static_cast<int64_t>(moment.link.state->obeyed_sequence);
        row.actual = &moment.link.state->q;
    }
    robot::appendDriveCsv(row, text_);
}

}  // namespace noctule::robot_link
