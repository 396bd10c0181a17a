// SPDX-License-Identifier: Apache-2.0
// Whom a simulation dresses and in what world, from the command line: the same words for `simulate` and for
// the virtual suit.
#pragma once

#include <nlohmann/json.hpp>

#include "app/batch/arguments.h"
#include "app/batch/console.h"
#include "core/simulation/simulate.h"

namespace noctule::batch {

/// motion, rig, scenario, suit, actor, rest-seconds, bvh-unit, up, height, bones.
std::vector<Option> stageOptions();

/// Reads the files that the options name. Wants `seed` in the table too; the duration is the caller's.
/// Neither motion nor rig: the rest pose. What was understood of the motion goes to the console and, for
/// machines, to `understood`.
Result<simulation::StageRequest> stageRequest(const Arguments& arguments, Console& console,
                                              nlohmann::json* understood = nullptr);

/// out, level, overwrite, and the take's name, date and program.
simulation::TakeRequest takeRequest(const Arguments& arguments);

}  // namespace noctule::batch
