// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_copy.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "core/job/atomic_file.h"
#include "core/recording/database.h"
#include "core/recording/recover_take.h"

namespace noctule {
namespace {

constexpr size_t kChunk_bytes = 4 << 20;

/// An empty file that those may read who may read the original: before there is anything in it.
Status makePrivate(const std::string& from, const std::string& to) {
    struct stat original {};
    const bool known = stat(from.c_str(), &original) == 0;
    const int file = ::open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const bool made = file >= 0 && known && fchmod(file, original.st_mode & 0777) == 0;
    if (file >= 0)
        close(file);
    return made ? Status(Done{})
                : Status(
                      Error{ErrorKind::kDisk, to + ": cannot be written", "Check that you may write there"});
}

Status copyFile(const std::string& from, const std::string& to, const JobContext& job) {
    std::ifstream in(from, std::ios::binary);
    if (!in)
        return Error{ErrorKind::kUnreadable, from + ": cannot be read", "Check the path and its permissions"};
    const Error disk{ErrorKind::kDisk, to + ": cannot be written", "Check that the folder has room"};
    std::error_code ignored;
    if (Status made = makePrivate(from, to); !made)
        return made;
    std::ofstream out(to, std::ios::binary);
    if (!out)
        return disk;
    const auto size = static_cast<double>(std::max<uintmax_t>(1, std::filesystem::file_size(from, ignored)));
    std::vector<char> chunk(kChunk_bytes);
    double done = 0;
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0) {
        if (job.cancelled())
            return JobContext::cancelledError();
        if (!out.write(chunk.data(), in.gcount()))
            return disk;
        done += static_cast<double>(in.gcount());
        job.progress(done / size, "Copying");
    }
    if (in.bad())
        return Error{ErrorKind::kUnreadable, from + ": cannot be read to its end", "Check the disk"};
    out.close();
    return out ? Status(Done{}) : Status(disk);
}

}  // namespace

TakeCopy::TakeCopy(std::string original, std::string path, std::string aside)
    : original_(std::move(original)), path_(std::move(path)), aside_(std::move(aside)) {}

TakeCopy::TakeCopy(TakeCopy&& other) noexcept
    : original_(std::move(other.original_)),
      path_(std::move(other.path_)),
      aside_(std::exchange(other.aside_, std::string())) {}

TakeCopy::~TakeCopy() {
    if (aside_.empty())
        return;
    std::error_code ignored;
    for (const char* ending : {"", "-wal", "-shm", "-journal"})
        std::filesystem::remove(aside_ + ending, ignored);
}

Result<TakeCopy> TakeCopy::make(const std::string& original, const std::string& path, const JobContext& job) {
    if (isBeingWritten(original))
        return beingRecorded(original);
    TakeCopy copy(original, path, asidePath(path));
    if (Status copied = copyFile(original, copy.aside_, job); !copied)
        return copy.named(copied.error());
    const std::string log = original + "-wal";
    std::error_code ignored;
    if (std::filesystem::exists(log, ignored))
        if (Status copied = copyFile(log, copy.aside_ + "-wal", job); !copied)
            return copy.named(copied.error());
    return copy;
}

Error TakeCopy::named(Error error) const {
    const std::string& path = error.kind == ErrorKind::kDisk ? path_ : original_;
    return namedAs(std::move(error), aside_, path);
}

/// SQLite does not bring a log into a file that was cut off, but into one of the length that the log states.
void TakeCopy::makeRoomForLog(const Database& database) const {
    std::error_code ignored;
    const auto log_bytes = std::filesystem::file_size(aside_ + "-wal", ignored);
    if (ignored || log_bytes == 0)
        return;
    const auto pages = database.queryInteger("PRAGMA page_count");
    const auto page_bytes = database.queryInteger("PRAGMA page_size");
    if (!pages || !page_bytes)
        return;
    const auto whole = static_cast<uintmax_t>(pages->value_or(0) * page_bytes->value_or(0));
    if (std::filesystem::file_size(aside_, ignored) < whole)
        std::filesystem::resize_file(aside_, whole, ignored);
}

Status TakeCopy::foldLog() {
    Result<Database> database = Database::open(aside_, Access::kReadWrite);
    if (!database)
        return named(database.error());
    if (Status tolerant = database->tolerateDamage(); !tolerant)
        return named(tolerant.error());
    makeRoomForLog(*database);
    if (Status done = database->execute("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode=DELETE"); !done)
        return named(done.error());
    if (Status closed = database->close(); !closed)
        return named(closed.error());
    return Done{};
}

void TakeCopy::dropLog() {
    std::error_code ignored;
    for (const char* ending : {"-wal", "-shm"})
        std::filesystem::remove(aside_ + ending, ignored);
}

Status TakeCopy::publish(bool overwrite) {
    Status published = publishFile(aside_, path_, overwrite);
    if (published)
        aside_.clear();
    return published;
}

}  // namespace noctule
