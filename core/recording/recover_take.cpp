// SPDX-License-Identifier: Apache-2.0
#include "core/recording/recover_take.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/job/atomic_file.h"
#include "core/recording/database.h"
#include "core/recording/first_page.h"
#include "core/recording/lost_branches.h"
#include "core/recording/salvage.h"
#include "core/recording/take_copy.h"
#include "core/recording/take_edit.h"

namespace noctule {

namespace {

/// Of the last page, where the file was cut off within it; else 0. SQLite reads zeros for what is missing.
uintmax_t bytesOfCutPage(const std::string& path) {
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    std::string header(kMagic.size() + 2, '\0');
    if (!std::ifstream(path, std::ios::binary).read(header.data(), std::ssize(header)) ||
        !header.starts_with(kMagic))
        return 0;
    const auto byte = [&](size_t at) {
        return static_cast<uintmax_t>(static_cast<unsigned char>(header[at]));
    };
    const uintmax_t stated = byte(16) << 8 | byte(17), page_bytes = stated == 1 ? 65536 : stated;
    std::error_code unknown;
    const uintmax_t size = std::filesystem::file_size(path, unknown);
    return unknown || page_bytes < 512 ? 0 : size % page_bytes;
}

/// Of a copy: rows that end behind the cut would seem whole.
void dropCutPage(const std::string& path) {
    std::error_code ignored;
    if (const uintmax_t bytes = bytesOfCutPage(path))
        std::filesystem::resize_file(path, std::filesystem::file_size(path, ignored) - bytes, ignored);
}

}  // namespace

Status checkIntegrity(const std::string& path, const JobContext& job) {
    Result<Database> database = Database::open(path, Access::kRead, {job.cancel});
    if (!database)
        return database.error();
    if (bytesOfCutPage(path) > 0)
        return Error{ErrorKind::kUnreadable, path + ": is damaged: it was cut off",
                     "Keep the file and its -wal; nothing was changed", true};
    database->watchReading(job, "Checking");
    Result<Statement> check = database->prepare("PRAGMA integrity_check(1)");
    if (!check)
        return check.error();
    const Result<bool> row = check->step();
    if (job.cancelled())  // which may look like damage
        return JobContext::cancelledError();
    if (!row)
        return row.error();
    const std::string verdict = *row ? check->text(0).value_or("") : "";
    if (verdict != "ok")
        return Error{ErrorKind::kUnreadable, path + ": is damaged: " + verdict,
                     "Keep the file and its -wal; nothing was changed", true};
    return Done{};
}

namespace {

Status markRecovered(const std::string& path) {
    Result<Take> take = Take::open(path, Access::kReadWrite);
    if (!take)
        return take.error();
    const Result<int64_t> samples = take->sampleCount();
    if (!samples)
        return samples.error();
    Result<TakeEdit> edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (*samples > 0)
        if (const Status set = edit->setMeta("sample_count", std::to_string(*samples)); !set)
            return set;
    if (const Status set = edit->setMeta("state", "recovered"); !set)
        return set;
    return edit->commit();
}

/// Until it is published.
struct SavedAside {
    std::string path;
    ~SavedAside() {
        std::error_code ignored;
        for (const char* ending : {"", "-wal", "-shm", "-journal"})
            std::filesystem::remove(path + ending, ignored);
    }
};

Status finishWhole(TakeCopy& copy, const JobContext& job) {
    if (const Status folded = copy.foldLog(); !folded)
        return folded;
    if (const Status sound = checkIntegrity(copy.path(), job); !sound)
        return sound;
    return markRecovered(copy.path());
}

/// `has_first_page`: its own, which says what pages are free.
Result<TakeLosses> saveReadable(TakeCopy& copy, const std::string& saved_path, bool has_first_page,
                                const JobContext& job) {
    if (const Status folded = copy.foldLog(); !folded) {
        if (folded.error().kind == ErrorKind::kDisk)
            return folded.error();
        copy.dropLog();  // it cannot be read, and would stand in the way of the file
    }
    const SavedAside saved{asidePath(saved_path)};
    const std::set<std::string> mended =
        has_first_page ? mendBranches(copy.path(), job) : std::set<std::string>();
    Result<TakeLosses> losses = copyReadableRows(copy.path(), saved.path, job, mended);
    if (!losses)
        return losses;
    const Status marked = markRecovered(saved.path);
    if (!marked && marked.error().kind == ErrorKind::kDisk)
        return namedAs(marked.error(), saved.path, saved_path);
    if (!marked)
        return Error{ErrorKind::kUnreadable,
                     copy.path() + ": too little of it can be read to make a take of it",
                     "Use a copy of it, if there is one"};
    if (const Status published = publishFile(saved.path, saved_path, false); !published)
        return published.error();
    return losses;
}

}  // namespace

Result<Recovery> recoverTake(const std::string& recording, const std::string& recovered_path,
                             const JobContext& job, const std::optional<Error>& damage) {
    // Of a copy: reading a file with a log beside it writes into it.
    Result<TakeCopy> copy = TakeCopy::make(recording, recovered_path, job);
    if (!copy)
        return copy.error();
    dropCutPage(copy->path());
    const Status whole = damage ? Status(*damage) : finishWhole(*copy, job);
    if (whole) {
        if (const Status published = copy->publish(false); !published)
            return published.error();
        return Recovery();
    }
    Result<TakeLosses> losses =
        whole.error().is_damage ? saveReadable(*copy, recovered_path, true, job) : whole.error();
    if (!losses && losses.error().kind == ErrorKind::kUnreadable && mendFirstPage(copy->path())) {
        losses = saveReadable(*copy, recovered_path, false, job);
        if (losses)
            losses->may_have_had_more = true;
    }
    if (!losses)
        return copy->named(losses.error());
    return Recovery{*losses};
}

namespace {

/// In a child process: whether somebody, the parent too, has a connection to the log's index. Only what a
/// signal handler may do is done here.
[[noreturn]] void lookForConnection(const char* index) {
    // Every connection holds a shared lock on this byte (sqlite3, UNIX_SHM_DMS in os_unix.c) as long as it
    // lives.
    constexpr off_t kConnectionLock = 128;
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = kConnectionLock;
    lock.l_len = 1;
    const int file = open(index, O_RDWR | O_CLOEXEC);
    _exit(file >= 0 && fcntl(file, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK ? 1 : 0);
}

}  // namespace

/// A process that closes a file gives up all its locks on it, those of its SQLite connections too, and does
/// not see its own. Hence a child asks: it inherits no locks, so it has none to lose.
bool isBeingWritten(const std::string& recording) {
    const std::string index = recording + "-shm";
    if (access(index.c_str(), F_OK) != 0)
        return false;
    const pid_t child = fork();
    if (child == 0)
        lookForConnection(index.c_str());
    int status = 0;
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0;
}

Error beingRecorded(const std::string& recording) {
    return {ErrorKind::kUnusable, recording + ": is being recorded, so it is left alone",
            "Wait until the recording has ended"};
}

}  // namespace noctule
