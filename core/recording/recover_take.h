// SPDX-License-Identifier: Apache-2.0
// Makes a finished take of a recording that broke off (README.md, section 7): everything that was committed,
// checked, with its length noted and `state` = recovered. The recording itself stays as it is. Nobody may be
// writing it.
#pragma once

#include <string>

#include "core/job/job.h"

namespace noctule {

/// kUsage when something stands at `recovered_path`, kUnreadable when the recording is damaged.
/// A recording that is being written would come out torn: ask isBeingWritten() first.
Status recoverTake(const std::string& recording, const std::string& recovered_path, const JobContext& job);

/// Of a take whose database is damaged: makes a take of all rows that can be read, `state` = recovered. The
/// damaged one stays as it is. kUnreadable when that makes no take.
Status saveReadable(const std::string& torn, const std::string& saved_path, const JobContext& job);

/// Whether anybody, this process included, has the take open with its write-ahead log; yes when that cannot
/// be found out. Safe to ask about a take that this process is writing.
bool isBeingWritten(const std::string& recording);

/// kUnusable, for those who would write into it.
Error beingRecorded(const std::string& recording);

}  // namespace noctule
