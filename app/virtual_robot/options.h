// SPDX-License-Identifier: Apache-2.0
// The command line of noctule-virtual-robot.
#pragma once

#include "app/batch/arguments.h"
#include "app/batch/help.h"
#include "app/virtual_robot/robot_body.h"
#include "app/virtual_suit/address.h"

namespace noctule::virtual_robot {

struct Options {
    batch::Arguments arguments;
    std::optional<virtual_suit::Address> udp{}, rosbridge{}, control{};
    BodyOptions body{};
};

/// kUsage names the mistake.
Result<Options> parseOptions(const std::vector<std::string>& words);

inline constexpr const char* kExample = "noctule-virtual-robot --robot g1.urdf --udp 127.0.0.1:41950";

std::string helpText();
const std::vector<batch::Option>& optionTable();

}  // namespace noctule::virtual_robot
