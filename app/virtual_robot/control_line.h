// SPDX-License-Identifier: Apache-2.0
// One line of the control port as a value.
#pragma once

#include <string>
#include <string_view>

#include "core/job/result.h"

namespace noctule::virtual_robot {

enum class FaultKind { kStall, kCut, kLatency, kLag, kRefuse, kAccept, kJointStuck, kJointFree, kQuit };

struct ControlLine {
    FaultKind kind = FaultKind::kQuit;
    double number = 0;  ///< seconds or milliseconds
    std::string joint;
};

/// kUsage says what is right.
Result<ControlLine> parseControlLine(std::string_view line);
std::string controlHelp();

}  // namespace noctule::virtual_robot
