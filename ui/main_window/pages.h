// SPDX-License-Identifier: Apache-2.0
// Which page stands for which step: one line each.
#pragma once

#include "ui/models/studio.h"
#include "ui/views/page.h"

namespace noctule::ui {

class RecentSessions;
class RobotDrive;

/// `robot`: of the step Robot.
Page* makePageFor(Step step, Studio& studio, RecentSessions& recent, RobotDrive& robot);

}  // namespace noctule::ui
