// SPDX-License-Identifier: Apache-2.0
// `noctule --batch VERB ...`: finds the verb, checks its arguments, runs it and prints what came of it.
#pragma once

#include <string>
#include <vector>

#include "core/job/job.h"

namespace noctule::batch {

/// `words` follow `--batch`. Returns the exit code.
int runBatch(const std::vector<std::string>& words, const CancelFlag& cancel);

/// "noctule 0.1.0-7-g1a2b3c4d", as it stands in takes.
std::string softwareName();

}  // namespace noctule::batch
