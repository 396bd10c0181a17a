// SPDX-License-Identifier: Apache-2.0
// Inside the room: what is checked and completed in a URDF document before urdfdom reads it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/job/result.h"

namespace noctule::robot {

/// The document with every missing limit filled in; `notices` gets a sentence for each.
Result<std::string> checkedUrdf(std::string_view text, const std::string& where,
                                std::vector<std::string>& notices);

}  // namespace noctule::robot
