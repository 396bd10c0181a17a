// SPDX-License-Identifier: Apache-2.0
// Motion files that verbs read: as they are understood, with the options that correct it. Everything that had
// to be decided is said on the console.
#pragma once

#include <nlohmann/json.hpp>

#include "app/batch/arguments.h"
#include "app/batch/console.h"
#include "core/figure/understood_motion.h"
#include "core/processing/outside_files.h"

namespace noctule::batch {

/// "--bvh-unit", "--up", "--height" and "--bones". `whose`: the option that names the file, without dashes.
std::vector<Option> motionOptions(const std::string& whose);
/// kUsage when one of them is given without the file.
Status checkMotionOptions(const Arguments& arguments, const std::string& whose);
Result<figure::MotionHints> motionHints(const Arguments& arguments);

Result<figure::UnderstoodMotion> readUnderstood(const std::string& path, const Arguments& arguments,
                                                Console& console);

/// What shows no whole person is taken as it is, with a warning, unless an option corrects it. `understood`:
/// for machines; null when it was taken as it is.
Result<OutsideMotion> readReference(const std::string& path, const Arguments& arguments, Console& console,
                                    nlohmann::json& understood);

}  // namespace noctule::batch
