// SPDX-License-Identifier: Apache-2.0
// One line of the control port as a value.
#pragma once

#include <string>
#include <string_view>

#include "core/job/result.h"
#include "core/simulation/rig_world.h"
#include "core/suit/suit.h"

namespace noctule::virtual_suit {

inline constexpr const char* kPoses[] = {"rest", "t", "sit"};

enum class ControlKind {
    kUnplug,
    kPlug,
    kSwap,
    kSlip,
    kPose,
    kSide,
    kSpin,
    kPlacement,
    kRoll,
    kHeight,
    kDropBytes,
    kFlipBits,
    kStall,
    kCut,
    kBattery,
    kTemperature,
    kQuit,
};

struct ControlCommand {
    ControlKind kind = ControlKind::kQuit;
    int board = -1, other_board = -1;  ///< indices in the suit
    /// Degrees, rate, seconds, percent, degrees Celsius, turns a minute, placement, metres.
    double number = 0;
    simulation::RigSide side{};  ///< of the boards, upwards
    std::string pose{};          ///< one of kPoses
};

/// BOARD is an id of the suit or a number from 1. Errors say what is right.
Result<ControlCommand> parseControlCommand(std::string_view line, const Suit& suit);

}  // namespace noctule::virtual_suit
