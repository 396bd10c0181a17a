// SPDX-License-Identifier: Apache-2.0
// The world frames of other programs' attitudes, and the turn into ours (Y up, Z north or forward, X west or
// left).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

enum class WorldFrame {
    kEastNorthUp,
    kNorthWestUp,  ///< MVN: X forward, Y left, Z up
    kNorthEastDown,
    kForwardUpRight,  ///< OpenSim's ground
    kOurs,
};

/// "enu", "nwu", "ned", "opensim", "noctule", in capitals or not.
std::optional<WorldFrame> worldFrameNamed(const std::string& name);
const std::vector<std::string>& worldFrameNames();
std::string worldFrameText(WorldFrame frame);

/// Takes vectors of the file's world to ours.
Quaterniond worldFromFile(WorldFrame frame);

}  // namespace noctule
