// SPDX-License-Identifier: Apache-2.0
// Commands as files: a table for spreadsheets and scripts, and trajectory_msgs/JointTrajectory of ROS as
// JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/robot/motion_mapping.h"

namespace noctule::robot {

/// Header `time_s,JOINT,...`, then a row per frame: seconds from the first frame, rad or m.
std::string commandTable(const RobotTrajectory& trajectory);

/// {"joint_names", "points": [{"positions", "velocities", "time_from_start": {"secs", "nsecs"}}]}. Velocities
/// are central differences, 0 at both ends unless the commands are a loop.
nlohmann::json jointTrajectory(const RobotTrajectory& trajectory);

}  // namespace noctule::robot
