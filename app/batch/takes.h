// SPDX-License-Identifier: Apache-2.0
// The same work on several takes. One that fails does not stop the others.
#pragma once

#include <functional>

#include "app/batch/verb.h"

namespace noctule::batch {

using TakeWork = std::function<Result<Outcome>(const std::string& take, const JobContext& job)>;

/// JSON {"takes": [...]} in the order given, where a failed one is {"take", "error"}; texts one after the
/// other. A single take's failure, and a cancel, are the whole result. `jobs`: takes at a time.
Result<Outcome> forEachTake(const VerbContext& context, size_t jobs, const TakeWork& work);

/// kUsage when one take is named twice: two jobs would write the same file.
Status checkDistinct(const std::vector<std::string>& takes);

}  // namespace noctule::batch
