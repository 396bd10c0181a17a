// SPDX-License-Identifier: Apache-2.0
// Why a process: the library that reads meshes has no limits of its own, recurses as deep as a file says and
// has had many faults. The alternatives were to repair it, which is not ours, or to write six readers.
#include "core/mesh/import/mesh_reader.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "core/job/own_folder.h"
#include "core/mesh/import/rigged_mesh_bytes.h"

namespace noctule {
namespace {

constexpr int kOutOfMemory = 12;  ///< exit code of the reader
constexpr int kLook_ms = 50;      ///< at a cancel while nothing comes
constexpr const char* kSurface = "surface";
constexpr const char* kMotion = "motion";
constexpr const char* kPart = "part";

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }
    int number() const { return number_; }
    void close() {
        if (number_ >= 0)
            ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

/// Starts the program with `output` as its standard output and nothing else of ours; its errno when it
/// cannot.
int startReader(const std::string& program, std::vector<std::string> arguments, int output, pid_t& pid) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    std::transform(arguments.begin(), arguments.end(), std::back_inserter(argv),
                   [](std::string& argument) { return argument.data(); });
    argv.push_back(nullptr);
    char* no_variables[] = {nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    const int failed = posix_spawn(&pid, program.c_str(), &actions, nullptr, argv.data(), no_variables);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

/// All that comes until the end, until `most` bytes are exceeded, or until a cancel.
std::string readAll(int descriptor, size_t most, const JobContext& job) {
    std::string bytes;
    std::vector<char> piece(1 << 18);
    while (bytes.size() <= most && !job.cancelled()) {
        pollfd readable{descriptor, POLLIN, 0};
        if (poll(&readable, 1, kLook_ms) == 0)
            continue;
        const ssize_t got = read(descriptor, piece.data(), piece.size());
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            break;
        bytes.append(piece.data(), static_cast<size_t>(got));
    }
    return bytes;
}

int waitFor(pid_t pid) {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

Error readerEnded(int status, const std::string& path, const ReadingLimits& limits) {
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    std::string what = "it cannot be read; the reader broke down over it";
    if (signal == SIGALRM || signal == SIGXCPU)
        what = "reading it took longer than " + std::to_string(limits.seconds) + " s";
    else if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory)
        what = "reading it takes more than " + std::to_string(limits.memory_mb) + " MB of memory";
    return {ErrorKind::kUnreadable, path + ": " + what,
            "Export the mesh again, simpler if it is very large; the file may be damaged"};
}

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t put = write(descriptor, bytes.data(), bytes.size());
        if (put < 0 && errno != EINTR)
            return false;
        bytes.remove_prefix(put > 0 ? static_cast<size_t>(put) : 0);
    }
    return true;
}

template <class Number>
bool parsed(const std::string& text, Number& number) {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

void limitMyself(unsigned seconds, size_t memory_mb) {
    alarm(seconds);
    const rlimit computing{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &computing);
    const rlimit core{0, 0};
    setrlimit(RLIMIT_CORE, &core);
#ifndef NOCTULE_SANITIZED  // sanitizers reserve terabytes of addresses
    const rlimit memory{memory_mb << 20, memory_mb << 20};
    setrlimit(RLIMIT_AS, &memory);
#else
    static_cast<void>(memory_mb);
#endif
}

}  // namespace

std::string meshReaderProgram() {
    return helperPath("noctule-read-mesh");
}

Result<RiggedMesh> importMeshApart(const std::string& path, const MeshImportSettings& settings,
                                   const JobContext& job, const std::string& program,
                                   const ReadingLimits& limits) {
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0)
        return Error{ErrorKind::kInternal, path + ": no pipe to a reader: " + std::strerror(errno),
                     "Close other programs and try again"};
    Descriptor from_reader(ends[0]), to_us(ends[1]);
    pid_t pid = 0;
    const int failed = startReader(program,
                                   {path, std::to_string(settings.unit_m.value_or(0)),
                                    std::to_string(limits.seconds), std::to_string(limits.memory_mb),
                                    settings.keeps_axes      ? kPart
                                    : settings.needs_surface ? kSurface
                                                             : kMotion},
                                   to_us.number(), pid);
    if (failed)
        return Error{ErrorKind::kInternal, program + " cannot be started: " + std::strerror(failed),
                     "Install the program again; this one belongs beside it"};
    to_us.close();
    const std::string bytes = readAll(from_reader.number(), limits.result_mb << 20, job);
    from_reader.close();
    const bool cancelled = job.cancelled();
    if (cancelled || bytes.size() > limits.result_mb << 20)
        kill(pid, SIGKILL);
    const int status = waitFor(pid);
    if (cancelled)
        return JobContext::cancelledError();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return readerEnded(status, path, limits);
    return meshFromBytes(bytes, path);
}

int runMeshReader(const std::vector<std::string>& arguments, TextureDecoder decode) {
    double unit_m = 0;
    unsigned seconds = 0;
    size_t memory_mb = 0;
    if (arguments.size() != 5 || !parsed(arguments[1], unit_m) || !parsed(arguments[2], seconds) ||
        !parsed(arguments[3], memory_mb) || seconds == 0)
        return static_cast<int>(ErrorKind::kUsage);
    limitMyself(seconds, memory_mb);
    try {
        MeshImportSettings settings;
        settings.decode = decode;
        settings.needs_surface = arguments[4] != kMotion;
        settings.keeps_axes = arguments[4] == kPart;
        if (unit_m > 0)
            settings.unit_m = unit_m;
        const std::string bytes = toBytes(importMesh(arguments[0], settings));
        return writeAll(STDOUT_FILENO, bytes) ? 0 : static_cast<int>(ErrorKind::kDisk);
    } catch (const std::bad_alloc&) {
        return kOutOfMemory;
    } catch (const std::exception&) {
        return static_cast<int>(ErrorKind::kInternal);
    }
}

}  // namespace noctule
