// SPDX-License-Identifier: Apache-2.0
// A cast from its file, with all files that it names: the same for `simulate` and for the virtual suit.
#pragma once

#include "app/batch/arguments.h"
#include "app/batch/console.h"
#include "core/simulation/cast.h"

namespace noctule::batch {

/// Reads CAST.json and the files beside it: paths are relative to the cast. Wants scenario, rest-seconds,
/// seed and those of motions in the table. `duration_s`: 0 is the longest motion once. What was understood of
/// each motion goes to the console.
Result<simulation::CastRequest> castRequest(const std::string& path, const Arguments& arguments,
                                            Console& console, double duration_s);

}  // namespace noctule::batch
