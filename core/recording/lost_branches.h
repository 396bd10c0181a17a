// SPDX-License-Identifier: Apache-2.0
// Where a page that leads to others is damaged, nothing leads to the sound pages below it. They are found by
// what stands on them, and led to again.
#pragma once

#include <set>
#include <string>

#include "core/job/job.h"

namespace noctule {

/// Makes damaged inner pages of a take's tables anew; `path` must be a copy without a log. A page is taken
/// for a table's only when no tree and no list of free pages has it, and all its rows have the table's
/// columns and numbers that are missing. The tables that have such pages come back: it is unknown what they
/// still lack.
std::set<std::string> mendBranches(const std::string& path, const JobContext& job);

}  // namespace noctule
