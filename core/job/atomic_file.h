// SPDX-License-Identifier: Apache-2.0
// Whole files, read and written at once. A file is written aside (in the same folder, so that the last step
// is a rename), synced, checked and only then given its name: at any moment the name stands for nothing, for
// the old file or for the complete new one.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

#include "core/job/job.h"
#include "core/job/result.h"

namespace noctule {

/// Whether a file may be written at `path`; long work asks before it starts. Something there without
/// `overwrite`, or something that is no regular file, is kUsage; a missing or read-only folder is kDisk.
Status checkOutputPath(const std::string& path, bool overwrite);

/// Looks at the file written aside before it gets its name; an Error abandons it. The content that was
/// written is not needed any more by then.
using AsideCheck = std::function<Status(const std::string& aside_path)>;

/// Writes `content` to `path` in whole or not at all (kUsage as above, kDisk when the system refuses).
Status writeFileAtomically(const std::string& path, std::string_view content, bool overwrite,
                           const AsideCheck& check = {});

/// A name beside `path` for a file that something else writes and publishFile() names; no other writer, here
/// or in another process, uses it.
std::string asidePath(const std::string& path);

/// An error about the file aside, told about the file that it is to become.
Error namedAs(Error error, const std::string& aside_path, const std::string& path);

/// Removes what writers of `path` left beside it when they were killed; what a living process writes stays,
/// and what another computer does in a shared folder (its host name stands in the file's).
void removeAbandoned(const std::string& path);

/// Syncs a finished file and renames it to `path` in the same folder; for files that something else writes,
/// such as a database. The file aside stays when this fails.
Status publishFile(const std::string& aside_path, const std::string& path, bool overwrite);

struct ReadOptions {
    size_t most_bytes = std::numeric_limits<size_t>::max();  ///< of a regular file
    size_t most_stream_bytes =
        std::numeric_limits<size_t>::max();  ///< of a pipe or device, which need not end
    const CancelFlag* cancel = nullptr;      ///< looked at ten times a second
};

/// The whole content of a file; kUnreadable when it cannot be opened or read or exceeds a limit. A pipe
/// without a writer is waited for.
Result<std::string> readWholeFile(const std::string& path, const ReadOptions& options = {});

}  // namespace noctule
