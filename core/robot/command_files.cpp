// SPDX-License-Identifier: Apache-2.0
#include "core/robot/command_files.h"

#include <cmath>
#include <cstdio>

#include "core/job/csv_cell.h"

namespace noctule::robot {
namespace {

std::string fixedNumber(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.9f", value);
    return text;
}

std::vector<double> speedsAt(const RobotTrajectory& trajectory, size_t frame) {
    const size_t count = trajectory.frames.size();
    const bool is_loop = !trajectory.loop_start_s.empty();
    std::vector<double> speeds(trajectory.joints.size(), 0);
    if (count < 2 || (!is_loop && (frame == 0 || frame + 1 == count)))
        return speeds;
    const auto& before = trajectory.frames[(frame + count - 1) % count];
    const auto& after = trajectory.frames[(frame + 1) % count];
    for (size_t j = 0; j < speeds.size(); ++j)
        speeds[j] = (after[j] - before[j]) / (2 * trajectory.frame_time_s);
    return speeds;
}

}  // namespace

std::string commandTable(const RobotTrajectory& trajectory) {
    std::string table = "time_s";
    for (const std::string& joint : trajectory.joints)
        table += "," + csvCell(joint);
    table += "\n";
    for (size_t i = 0; i < trajectory.frames.size(); ++i) {
        table += fixedNumber(static_cast<double>(i) * trajectory.frame_time_s);
        for (const double value : trajectory.frames[i])
            table += "," + fixedNumber(value);
        table += "\n";
    }
    return table;
}

nlohmann::json jointTrajectory(const RobotTrajectory& trajectory) {
    nlohmann::json points = nlohmann::json::array();
    for (size_t i = 0; i < trajectory.frames.size(); ++i) {
        const auto time_ns = std::llround(static_cast<double>(i) * trajectory.frame_time_s * 1e9);
        points.push_back(
            {{"positions", trajectory.frames[i]},
             {"velocities", speedsAt(trajectory, i)},
             {"time_from_start", {{"secs", time_ns / 1'000'000'000}, {"nsecs", time_ns % 1'000'000'000}}}});
    }
    return {{"joint_names", trajectory.joints}, {"points", std::move(points)}};
}

}  // namespace noctule::robot
