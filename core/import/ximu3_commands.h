// SPDX-License-Identifier: Apache-2.0
// What an x-IMU3 says of itself: the answers to commands, in Command.json beside the tables or as lines of
// the byte stream. Nothing here changes a reading: messages hold calibrated values, along the axes that are
// set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/import/world_frame.h"

namespace noctule {

struct Ximu3Settings {
    std::string name, serial_number, time, calibration_date;
    std::optional<WorldFrame> world;  ///< of its attitudes
    std::optional<int> axes_alignment, inertial_divisor;
    bool is_damaged = false;  ///< it is no JSON
};

/// A list of answers, or one. What is said twice counts as said last; settings of other kinds are left out.
void addXimu3Commands(std::string_view text, Ximu3Settings& settings);

/// Whole sentences without the last stop; none where nothing was said.
std::vector<std::string> ximu3Notes(const std::string& id, const Ximu3Settings& settings);

}  // namespace noctule
