// SPDX-License-Identifier: Apache-2.0
// The profile of a robot as verbs find it: the file that was named, else the saved one of the robot's name,
// else made from the URDF.
#pragma once

#include <string>

#include "app/batch/arguments.h"
#include "core/robot/motion_mapping.h"

namespace noctule::batch {

/// `path` empty: not named.
Result<robot::RobotProfile> robotProfile(const robot::RobotModel& model, const std::string& path);

/// Which parts of a robot are driven: --arms and --trunk.
Option armsOption();
Option trunkOption();
robot::MappingChoice partsChoice(const Arguments& arguments);

}  // namespace noctule::batch
