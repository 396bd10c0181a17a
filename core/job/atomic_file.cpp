// SPDX-License-Identifier: Apache-2.0
#include "core/job/atomic_file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace noctule {
namespace {

constexpr const char* kAsideEnding = ".partial";

std::string folderOf(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string remedyFor(int code, const std::string& path) {
    switch (code) {
        case ENOSPC:
        case EDQUOT:
            return "Free some space there or choose another folder";
        case ENOENT:
        case ENOTDIR:
            return "Create the folder " + folderOf(path) + " first or correct the path";
        case EACCES:
        case EPERM:
        case EROFS:
            return "Choose a folder that you may write to";
        case ENAMETOOLONG:
            return "Choose a shorter name";
        default:
            return "Check the disk or choose another folder";
    }
}

Error diskError(const std::string& path, int code) {
    return {ErrorKind::kDisk, path + ": cannot be written: " + std::generic_category().message(code),
            remedyFor(code, path)};
}

Error existsError(const std::string& path) {
    return {ErrorKind::kUsage, path + " exists already", "Choose another name or give --overwrite"};
}

/// An open descriptor; close() reports what the destructor must swallow.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int get() const { return fd_; }
    bool close() {
        const int fd = fd_;
        fd_ = -1;
        return fd < 0 || ::close(fd) == 0;
    }

private:
    int fd_;
};

/// Removes the file aside unless it has got its name.
class AsideFile {
public:
    explicit AsideFile(std::string path) : path_(std::move(path)) {}
    AsideFile(const AsideFile&) = delete;
    AsideFile& operator=(const AsideFile&) = delete;
    ~AsideFile() {
        if (!published_)
            ::unlink(path_.c_str());
    }
    const std::string& path() const { return path_; }
    void published() { published_ = true; }

private:
    std::string path_;
    bool published_ = false;
};

/// This computer's, as far as it fits into a file's name: a process number says nothing of another computer's
/// process, and a folder may be shared.
std::string hostName() {
    std::array<char, 33> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0 && errno != ENAMETOOLONG)
        return "unnamed";
    std::string host = name.data();
    for (char& c : host)
        if (!std::isalnum(static_cast<unsigned char>(c)))
            c = '-';
    return host.empty() ? "unnamed" : host;
}

/// What the names of all files aside of `path` begin with that processes of this computer write.
std::string asideBegin(const std::string& path) {
    return "." + std::filesystem::path(path).filename().string() + "." + hostName() + ".";
}

/// A name that no other writer, here or in another process, uses at this moment. The files stand beside their
/// targets, hidden, and are told from finished ones by their ending.
std::string asideName(const std::string& path) {
    static std::atomic<unsigned> count{0};
    const std::string name = asideBegin(path) + std::to_string(::getpid()) + "-" + std::to_string(count++);
    return (std::filesystem::path(path).parent_path() / (name + kAsideEnding)).string();
}

bool writeAll(int fd, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(fd, content.data(), content.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        content.remove_prefix(static_cast<size_t>(written));
    }
    return true;
}

/// A rename is on the disk once its folder is; file systems that cannot sync a folder need not.
void syncFolder(const std::string& path) {
    const Descriptor folder(::open(folderOf(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() >= 0)
        ::fsync(folder.get());
}

/// Without `overwrite` the rename itself refuses to replace, so that a file made meanwhile by somebody else
/// is safe; where the file system cannot do that, the check just before has to do.
Status giveName(const std::string& aside_path, const std::string& path, bool overwrite) {
    if (!overwrite) {
        if (::renameat2(AT_FDCWD, aside_path.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE) == 0)
            return Done{};
        if (errno == EEXIST)
            return existsError(path);
        if (errno != EINVAL && errno != ENOSYS)
            return diskError(path, errno);
        if (Status free = checkOutputPath(path, false); !free)
            return free;
    }
    if (::rename(aside_path.c_str(), path.c_str()) != 0)
        return diskError(path, errno);
    return Done{};
}

Error unreadable(const std::string& path, int code) {
    return {ErrorKind::kUnreadable, path + ": cannot be read: " + std::generic_category().message(code),
            code == ENOENT ? "Check the path" : "Check that it is a file that you may read"};
}

/// Opens without waiting, so that a pipe that nobody writes to can be given up.
class WholeFile {
public:
    WholeFile(const std::string& path, const ReadOptions& options)
        : path_(path),
          options_(options),
          descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}

    Result<std::string> read() {
        struct stat found {};
        if (descriptor_.get() < 0 || ::fstat(descriptor_.get(), &found) != 0)
            return unreadable(path_, errno);
        if (S_ISDIR(found.st_mode))
            return unreadable(path_, EISDIR);
        most_ = S_ISREG(found.st_mode) ? options_.most_bytes : options_.most_stream_bytes;
        if (S_ISREG(found.st_mode) && static_cast<size_t>(found.st_size) > most_)
            return tooLarge();
        std::string content(static_cast<size_t>(found.st_size) + 1,
                            '\0');  // one more, to see the end at once
        size_t length = 0;
        while (true) {
            if (length > most_)
                return tooLarge();
            if (length == content.size())
                content.resize(content.size() + std::max<size_t>(4096, content.size() / 2));
            if (Status ready = awaitData(); !ready)
                return ready.error();
            const size_t wanted = std::min(content.size() - length, kPiece);
            const ssize_t got = ::read(descriptor_.get(), content.data() + length, wanted);
            if (got < 0 && (errno == EINTR || errno == EAGAIN))
                continue;
            if (got < 0)
                return unreadable(path_, errno);
            if (got == 0)
                break;
            length += static_cast<size_t>(got);
        }
        content.resize(length);
        return content;
    }

private:
    static constexpr size_t kPiece = 16 << 20;  ///< between two looks at the cancel flag
    static constexpr int kWait_ms = 100;

    /// Until there is something to read or the writer has closed.
    Status awaitData() const {
        while (true) {
            if (options_.cancel && options_.cancel->cancelled())
                return JobContext::cancelledError();
            pollfd waiting{descriptor_.get(), POLLIN, 0};
            const int ready = ::poll(&waiting, 1, kWait_ms);
            if (ready > 0)
                return Done{};
            if (ready < 0 && errno != EINTR)
                return unreadable(path_, errno);
        }
    }

    Error tooLarge() const {
        return {ErrorKind::kUnreadable,
                path_ + ": holds more than " + std::to_string(most_ >> 20) + " MB, the most that is read",
                "Check that it is the right file, or cut it into parts"};
    }

    const std::string& path_;
    const ReadOptions& options_;
    Descriptor descriptor_;
    size_t most_ = 0;
};

}  // namespace

Status checkOutputPath(const std::string& path, bool overwrite) {
    struct stat found {};
    if (path.empty())
        return Error{ErrorKind::kUsage, "the output has no name", "Give the path of a file"};
    if (::stat(path.c_str(), &found) == 0) {
        if (!S_ISREG(found.st_mode))
            return Error{ErrorKind::kUsage, path + " is not a file", "Give the path of a file"};
        if (!overwrite)
            return existsError(path);
    } else if (errno != ENOENT) {
        return diskError(path, errno);
    }
    if (::access(folderOf(path).c_str(), W_OK | X_OK) != 0)
        return diskError(path, errno);
    return Done{};
}

std::string asidePath(const std::string& path) {
    return asideName(path);
}

Error namedAs(Error error, const std::string& aside_path, const std::string& path) {
    for (std::string* text : {&error.message, &error.remedy})
        for (size_t at = 0; (at = text->find(aside_path, at)) != std::string::npos; at += path.size())
            text->replace(at, aside_path.size(), path);
    return error;
}

void removeAbandoned(const std::string& path) {
    const std::string begin = asideBegin(path);
    std::error_code ignored;
    std::filesystem::directory_iterator entry(folderOf(path), ignored);
    for (; entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        const char* number = name.c_str() + begin.size();
        char* end = nullptr;
        if (!name.starts_with(begin) || name.find(kAsideEnding) == std::string::npos)
            continue;
        const long writer = std::strtol(number, &end, 10);
        if (end != number && *end == '-' && writer > 0 && ::kill(static_cast<pid_t>(writer), 0) != 0 &&
            errno == ESRCH)
            std::filesystem::remove(entry->path(), ignored);
    }
}

Status publishFile(const std::string& aside_path, const std::string& path, bool overwrite) {
    Descriptor aside(::open(aside_path.c_str(), O_RDONLY | O_CLOEXEC));
    if (aside.get() < 0 || ::fsync(aside.get()) != 0 || !aside.close())
        return diskError(path, errno);
    Status named = giveName(aside_path, path, overwrite);
    if (named)
        syncFolder(path);
    return named;
}

Status writeFileAtomically(const std::string& path, std::string_view content, bool overwrite,
                           const AsideCheck& check) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    const std::string aside_path = asideName(path);
    Descriptor descriptor(::open(aside_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (descriptor.get() < 0)
        return diskError(path, errno);
    AsideFile aside(aside_path);
    if (!writeAll(descriptor.get(), content) || ::fsync(descriptor.get()) != 0 || !descriptor.close())
        return diskError(path, errno);
    if (check) {
        if (Status checked = check(aside.path()); !checked)
            return checked;
    }
    Status named = giveName(aside.path(), path, overwrite);
    if (named) {
        aside.published();
        syncFolder(path);
    }
    return named;
}

Result<std::string> readWholeFile(const std::string& path, const ReadOptions& options) {
    return WholeFile(path, options).read();
}

}  // namespace noctule
