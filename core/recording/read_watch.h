// SPDX-License-Identifier: Apache-2.0
// Looks at a job whenever SQLite reads a page. SQLite's own look at a whole file is one step of its machine,
// which asks nobody meanwhile.
#pragma once

#include <memory>
#include <string>

#include "core/job/job.h"

struct sqlite3;

namespace noctule {

struct ReadWatch;

/// Reports the part of the connection's file that was read since, as `stage`, and interrupts a statement
/// whose job is cancelled. Must outlive the connection.
std::shared_ptr<ReadWatch> watchReading(sqlite3* handle, const JobContext& job, const std::string& stage);

}  // namespace noctule
