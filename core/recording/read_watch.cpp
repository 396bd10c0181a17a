// SPDX-License-Identifier: Apache-2.0
#include "core/recording/read_watch.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace noctule {

/// SQLite's functions for one open file, of which one is ours.
struct ReadWatch {
    sqlite3_io_methods methods;  ///< first, so that the file, which refers to it, leads to the rest
    const sqlite3_io_methods* original = nullptr;
    sqlite3* handle = nullptr;
    JobContext job;
    std::string stage;
    int64_t whole_bytes = 0, read_bytes = 0;
    int64_t told_percent = -1;
};
static_assert(std::is_standard_layout_v<ReadWatch>);

namespace {

int readWatched(sqlite3_file* file, void* into, int bytes, sqlite3_int64 at) {
    auto& watch = *reinterpret_cast<ReadWatch*>(const_cast<sqlite3_io_methods*>(file->pMethods));
    if (watch.job.cancelled())
        sqlite3_interrupt(watch.handle);
    watch.read_bytes += bytes;
    // Some pages are read twice.
    const int64_t percent =
        watch.whole_bytes > 0 ? std::min<int64_t>(100, 100 * watch.read_bytes / watch.whole_bytes) : 0;
    if (percent > watch.told_percent)
        watch.job.progress(static_cast<double>(watch.told_percent = percent) / 100, watch.stage);
    return watch.original->xRead(file, into, bytes, at);
}

}  // namespace

std::shared_ptr<ReadWatch> watchReading(sqlite3* handle, const JobContext& job, const std::string& stage) {
    sqlite3_file* file = nullptr;
    if (sqlite3_file_control(handle, "main", SQLITE_FCNTL_FILE_POINTER, &file) != SQLITE_OK || !file ||
        !file->pMethods)
        return nullptr;
    auto watch = std::make_shared<ReadWatch>();
    watch->original = file->pMethods;
    watch->methods = *file->pMethods;
    watch->methods.xRead = readWatched;
    watch->handle = handle;
    watch->job = job;
    watch->stage = stage;
    sqlite3_int64 bytes = 0;
    if (watch->original->xFileSize(file, &bytes) == SQLITE_OK)
        watch->whole_bytes = bytes;
    file->pMethods = &watch->methods;
    return watch;
}

}  // namespace noctule
