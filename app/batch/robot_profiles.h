// SPDX-License-Identifier: Apache-2.0
// The profile of a robot as verbs find it: the file that was named, else the saved one of the robot's name,
// else made from the URDF.
#pragma once

#include <string>

#include "core/robot/motion_mapping.h"

namespace noctule::batch {

/// `path` empty: not named.
Result<robot::RobotProfile> robotProfile(const robot::RobotModel& model, const std::string& path);

/// "both", "left" or "right".
robot::MappingChoice armChoice(const std::string& arms);

}  // namespace noctule::batch
