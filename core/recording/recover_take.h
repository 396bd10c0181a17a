// SPDX-License-Identifier: Apache-2.0
// Makes a finished take of a recording that broke off (README.md, section 7): everything that was committed,
// checked, with its length noted and `state` = recovered. The recording itself stays as it is. Nobody may be
// writing it.
#pragma once

#include <optional>
#include <string>

#include "core/job/job.h"
#include "core/recording/losses.h"

namespace noctule {

/// Of a take that was whole: no losses.
using Recovery = std::optional<TakeLosses>;

/// Of a damaged one, finished or not: a take of all rows that can be read. kUsage when something stands at
/// `recovered_path`, kUnreadable when nothing can be read.
/// A recording that is being written would come out torn: ask isBeingWritten() first. `damage`: why it is
/// known to be damaged, so that it need not be checked.
Result<Recovery> recoverTake(const std::string& recording, const std::string& recovered_path,
                             const JobContext& job, const std::optional<Error>& damage = std::nullopt);

/// SQLite's own look at every page and index. Error::is_damage: recoverTake() saves what can be read.
Status checkIntegrity(const std::string& path, const JobContext& job);

/// Whether anybody, this process included, has the take open with its write-ahead log; yes when that cannot
/// be found out. Safe to ask about a take that this process is writing.
bool isBeingWritten(const std::string& recording);

/// kUnusable, for those who would write into it.
Error beingRecorded(const std::string& recording);

}  // namespace noctule
