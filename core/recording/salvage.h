// SPDX-License-Identifier: Apache-2.0
// Reads a damaged database row by row, as the take that it was.
#pragma once

#include <set>
#include <string>

#include "core/job/job.h"
#include "core/recording/losses.h"

namespace noctule {

/// Makes the database `path` of all rows of the tables of a take that can be read in `torn`, which nobody
/// else may have open, and which has no log beside it. kUnreadable when there is none. `mended`: tables of
/// which it is unknown what they lack.
Result<TakeLosses> copyReadableRows(const std::string& torn, const std::string& path, const JobContext& job,
                                    const std::set<std::string>& mended = {});

}  // namespace noctule
