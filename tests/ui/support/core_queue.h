// SPDX-License-Identifier: Apache-2.0
// For how long a thread could have run and the machine had no core for it: the second number of
// /proc/PID/task/TID/schedstat (Documentation/scheduler/sched-stats.rst). The interface's thread also waits
// for the X server, which waits for cores itself; of the time in which our thread neither ran nor queued, at
// most as much as the server queued is taken off. Where the kernel keeps no schedstat, nothing is taken off.
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

namespace noctule::ui::test {

class CoreQueue {
public:
    /// Since the call before.
    struct Passed {
        double ran_ms = 0, queued_ms = 0, server_queued_ms = 0;

        double withoutQueues_ms(double wall_ms) const {
            const double blocked_ms = std::max(0.0, wall_ms - ran_ms - queued_ms);
            return wall_ms - queued_ms - std::min(blocked_ms, server_queued_ms);
        }
    };

    /// Of the calling thread.
    CoreQueue() : own_(taskFile(std::to_string(gettid()))), server_("/proc/" + serverPid() + "/schedstat") {}

    bool isKept() const { return own_.isOpen(); }

    Passed passed() {
        Passed passed;
        own_.advance(passed.ran_ms, passed.queued_ms);
        double server_ran_ms = 0;
        server_.advance(server_ran_ms, passed.server_queued_ms);
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
};

}  // namespace noctule::ui::test
