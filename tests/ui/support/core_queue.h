// SPDX-License-Identifier: Apache-2.0
// For how long a thread could have run and the machine had no core for it: the second number of
// /proc/PID/task/TID/schedstat (Documentation/scheduler/sched-stats.rst). The interface's thread also waits
// for those who paint for it, a software OpenGL's threads ("llvmpipe-0") and the X server, and they wait for
// cores themselves; of the time in which our thread neither ran nor queued, at most as much as they queued is
// taken off. Where the kernel keeps no schedstat, nothing is taken off.
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>

namespace noctule::ui::test {

class CoreQueue {
public:
    /// Since the call before.
    struct Passed {
        double ran_ms = 0, queued_ms = 0, painters_queued_ms = 0;

        double withoutQueues_ms(double wall_ms) const {
            const double blocked_ms = std::max(0.0, wall_ms - ran_ms - queued_ms);
            return wall_ms - queued_ms - std::min(blocked_ms, painters_queued_ms);
        }
    };

    /// Of the calling thread.
    CoreQueue() : own_(taskFile(std::to_string(gettid()))), server_("/proc/" + serverPid() + "/schedstat") {}

    bool isKept() const { return own_.isOpen(); }

    Passed passed() {
        lookForPainters();
        Passed passed;
        own_.advance(passed.ran_ms, passed.queued_ms);
        double ran_ms = 0, longest_ms = 0, server_ms = 0;
        for (auto& [name, painter] : painters_) {
            double queued_ms = 0;
            painter->advance(ran_ms, queued_ms);
            longest_ms = std::max(longest_ms, queued_ms);
        }
        server_.advance(ran_ms, server_ms);
        passed.painters_queued_ms = longest_ms + server_ms;
        return passed;
    }

private:
    /// One schedstat, kept open.
    class Counter {
    public:
        explicit Counter(const std::string& path) : file_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
        Counter(const Counter&) = delete;
        Counter& operator=(const Counter&) = delete;
        ~Counter() {
            if (file_ >= 0)
                close(file_);
        }
        bool isOpen() const { return file_ >= 0; }
        void advance(double& ran_ms, double& queued_ms) {
            char text[96] = {};
            unsigned long long ran_ns = 0, queued_ns = 0;
            if (file_ < 0 || pread(file_, text, sizeof text - 1, 0) <= 0 ||
                std::sscanf(text, "%llu %llu", &ran_ns, &queued_ns) != 2)
                return;
            ran_ms = static_cast<double>(ran_ns - ran_ns_) * 1e-6;
            queued_ms = static_cast<double>(queued_ns - queued_ns_) * 1e-6;
            ran_ns_ = ran_ns, queued_ns_ = queued_ns;
        }

    private:
        int file_;
        unsigned long long ran_ns_ = 0, queued_ns_ = 0;
    };

    static std::string taskFile(const std::string& tid) { return "/proc/self/task/" + tid + "/schedstat"; }

    /// New ones begin with nothing queued, so that it is no matter when they are found.
    void lookForPainters() {
        std::error_code gone;
        for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", gone)) {
            const std::string tid = task.path().filename().string();
            if (known_.contains(tid))
                continue;
            std::string name;
            std::getline(std::ifstream(task.path() / "comm"), name);
            const bool paints = name.starts_with("llvmpipe");
            known_[tid] = paints;
            if (paints)
                painters_[tid] = std::make_unique<Counter>(taskFile(tid));
        }
    }

    /// Who listens at the other end of our connection to the screen; "0" when there is none.
    static std::string serverPid() {
        constexpr int kMostFiles = 64;
        for (int file = 3; file < kMostFiles; ++file) {
            sockaddr_un address{};
            socklen_t size = sizeof address;
            if (getpeername(file, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
                address.sun_family != AF_UNIX)
                continue;
            const char* path = address.sun_path + (address.sun_path[0] == 0 ? 1 : 0);
            ucred peer{};
            socklen_t peer_size = sizeof peer;
            if (std::strstr(path, "X11-unix") &&
                getsockopt(file, SOL_SOCKET, SO_PEERCRED, &peer, &peer_size) == 0)
                return std::to_string(peer.pid);
        }
        return "0";
    }

    Counter own_, server_;
    std::map<std::string, bool> known_;
    std::map<std::string, std::unique_ptr<Counter>> painters_;
};

}  // namespace noctule::ui::test
