// SPDX-License-Identifier: Apache-2.0
// Whom a simulation dresses and in what world, from the command line: the same words for `simulate` and for
// the virtual suit.
#pragma once

#include "app/batch/arguments.h"
#include "app/batch/console.h"
#include "core/simulation/simulate.h"

namespace noctule::batch {

/// motion, rig, scenario, suit, actor, rest-seconds, bvh-unit.
std::vector<Option> stageOptions();

/// Reads the files that the options name. Wants `seed` in the table too; the duration is the caller's.
/// Neither motion nor rig: the rest pose.
Result<simulation::StageRequest> stageRequest(const Arguments& arguments, Console& console);

}  // namespace noctule::batch
