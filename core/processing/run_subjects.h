// SPDX-License-Identifier: Apache-2.0
// Whose poses a run holds.
#pragma once

#include "core/recording/take.h"

namespace noctule {

/// The take's subjects of whom the pose run of that name (empty: the last one) holds poses; at least one.
/// Errors as those of choosePoseRun().
Result<std::vector<TakeSubject>> subjectsOfRun(const std::string& take_path, const std::string& run);

}  // namespace noctule
