// SPDX-License-Identifier: Apache-2.0
#include "app/batch/robot_profiles.h"

#include "app/batch/signals.h"
#include "core/robot/saved_profile.h"

namespace noctule::batch {

Result<robot::RobotProfile> robotProfile(const robot::RobotModel& model, const std::string& path) {
    return robot::profileFor(model, path, &signalFlag());
}

robot::MappingChoice armChoice(const std::string& arms) {
    robot::MappingChoice choice;
    choice.left = arms != "right";
    choice.right = arms != "left";
    return choice;
}

}  // namespace noctule::batch
