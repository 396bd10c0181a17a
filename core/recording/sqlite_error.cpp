// SPDX-License-Identifier: Apache-2.0
#include "core/recording/sqlite_error.h"

#include <sqlite3.h>

#include "core/job/job.h"

namespace noctule {

Error sqliteError(sqlite3* handle, const std::string& name) {
    const std::string detail = handle ? std::string(" (") + sqlite3_errmsg(handle) + ")" : "";
    switch (handle ? sqlite3_errcode(handle) & 0xff : SQLITE_NOMEM) {
        case SQLITE_NOTADB:
            return {ErrorKind::kUnreadable, name + ": is not a take", "Choose a .noctule file"};
        case SQLITE_CORRUPT:
        case SQLITE_TOOBIG:
            return {ErrorKind::kUnreadable, name + ": the file is damaged",
                    "Run `noctule --batch recover` on it, which saves what can be read into a new file",
                    true};
        case SQLITE_INTERRUPT:
            return JobContext::cancelledError();
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {ErrorKind::kUnreadable, name + ": another program holds a lock on the file",
                    "Wait until the other program is done, or close it, and try again"};
        case SQLITE_CANTOPEN:
            return {ErrorKind::kUnreadable, name + ": cannot be opened" + detail,
                    "Check the path and the permissions of the file and its folder"};
        case SQLITE_READONLY:
        case SQLITE_PERM:
            return {ErrorKind::kDisk, name + ": cannot be written",
                    "Copy the file to a folder where you may write"};
        case SQLITE_FULL:
            return {ErrorKind::kDisk, name + ": the disk is full", "Free some space and try again"};
        case SQLITE_IOERR:
            return {ErrorKind::kDisk, name + ": reading or writing the disk failed" + detail,
                    "Check the disk and try again"};
        case SQLITE_CONSTRAINT:
            return {ErrorKind::kUnusable, name + ": a row contradicts another one" + detail,
                    "Check that the same data is not added twice"};
        default:
            return {ErrorKind::kUnreadable, name + ": unexpected content" + detail,
                    "Run `noctule --batch inspect` on it to see what is there"};
    }
}

}  // namespace noctule
