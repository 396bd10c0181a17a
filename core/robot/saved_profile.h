// SPDX-License-Identifier: Apache-2.0
// The profile of a robot as programs find it: the file that was named, else the shipped one of the robot's
// name, else made from the URDF.
#pragma once

#include "core/job/job.h"
#include "core/robot/profile.h"

namespace noctule::robot {

/// `path` empty: not named.
Result<RobotProfile> profileFor(const RobotModel& model, const std::string& path,
                                const CancelFlag* cancel = nullptr);

}  // namespace noctule::robot
