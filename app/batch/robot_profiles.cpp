// SPDX-License-Identifier: Apache-2.0
#include "app/batch/robot_profiles.h"

#include "app/batch/signals.h"
#include "core/robot/saved_profile.h"

namespace noctule::batch {

Result<robot::RobotProfile> robotProfile(const robot::RobotModel& model, const std::string& path) {
    return robot::profileFor(model, path, &signalFlag());
}

Option armsOption() {
    return choice("arms", {"both", "left", "right"}, "which of the profile's arms are driven").orElse("both");
}

Option trunkOption() {
    return flag("trunk", "the robot's waist follows the performer's chest");
}

robot::MappingChoice partsChoice(const Arguments& arguments) {
    const std::string arms = arguments.text("arms");
    robot::MappingChoice choice;
    choice.left = arms != "right";
    choice.right = arms != "left";
    choice.trunk = arguments.given("trunk");
    return choice;
}

}  // namespace noctule::batch
