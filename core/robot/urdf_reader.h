// SPDX-License-Identifier: Apache-2.0
// Reads URDF, the robot description of ROS (wiki.ros.org/urdf/XML), through urdfdom. What urdfdom accepts
// silently is refused first: loops, names twice, limits that are no numbers or the wrong way round. Meshes
// are named, not read.
#pragma once

#include <string>
#include <string_view>

#include "core/job/job.h"
#include "core/robot/robot_model.h"

namespace noctule::robot {

/// kUnreadable names the file, the joint or link, and the remedy. A missing limit is no error: the default of
/// robot_model.h is taken and stands in `notices`.
Result<RobotModel> readUrdf(const std::string& path, const CancelFlag* cancel = nullptr);
/// The same from memory; `where` names the text in errors.
Result<RobotModel> parseUrdf(std::string_view text, const std::string& where);

}  // namespace noctule::robot
