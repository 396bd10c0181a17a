// SPDX-License-Identifier: Apache-2.0
// noctule-virtual-robot without its main(): reads the robot, opens the ports, works until told to end.
#pragma once

#include <string>
#include <vector>

#include "core/job/job.h"

namespace noctule::virtual_robot {

/// The exit code. A QCoreApplication must exist.
int runVirtualRobot(const std::vector<std::string>& words, const CancelFlag& cancel);

}  // namespace noctule::virtual_robot
