// SPDX-License-Identifier: Apache-2.0
// The parts of a robot that a performer drives live, and the order of their joints in commands and states.
#pragma once

#include "core/robot/motion_mapping.h"
#include "core/robot/trunk_follower.h"

namespace noctule::robot {

struct DrivenParts {
    std::vector<RobotArm> arms;  ///< one at least
    std::optional<RobotTrunk> trunk;

    /// The chains in the order of commands: the arms', then the trunk's.
    std::vector<const Chain*> chains() const;
    std::vector<std::string> joints() const;  ///< names in the order of commands
    std::vector<double> speeds() const;       ///< rad/s, likewise
    std::vector<double> reference() const;    ///< likewise: arms in their reference posture, the trunk at 0
};

/// The arms and the trunk that the choice names; never legs, which keep the robot's balance, and that is its
/// own controller's. kUnusable when there is no arm, the trunk has no joints, or two parts share a joint.
Result<DrivenParts> drivenParts(const RobotModel& model, const RobotProfile& profile,
                                const MappingChoice& choice);

}  // namespace noctule::robot
