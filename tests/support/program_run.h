// SPDX-License-Identifier: Apache-2.0
// The built program, started as any user would: arguments in, exit code and both outputs back.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/take_files.h"

extern char** environ;

namespace noctule::test {

inline const std::string kMotion = "/usr/share/assimp/models/BVH/01_01.bvh";
struct Ran {
    int exit_code = -1;
    std::string out, err;

    nlohmann::json json() const {
        auto parsed = nlohmann::json::parse(out, nullptr, false);
        EXPECT_FALSE(parsed.is_discarded()) << "not one JSON object: " << out;
        return parsed;
    }
};

/// A program that has been started, both outputs into files.
class Started {
public:
    explicit Started(std::vector<std::string> arguments, const std::string& program = NOCTULE_PROGRAM) {
        arguments.insert(arguments.begin(), program);
        std::vector<char*> argv;
        for (std::string& argument : arguments)
            argv.push_back(argument.data());
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        const int flags = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, outputs_.file("out").c_str(), flags, 0600);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, outputs_.file("err").c_str(), flags, 0600);
        EXPECT_EQ(posix_spawn(&pid_, program.c_str(), &actions, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
    }
    void send(int signal) const { kill(pid_, signal); }
    /// It has come so far that it handles the signal; on a busy machine that takes a while.
    bool catches(int signal) const {
        const std::string status = readBytes("/proc/" + std::to_string(pid_) + "/status");
        const size_t caught = status.find("SigCgt:");
        return caught != std::string::npos &&
               (std::stoull(status.substr(caught + 7), nullptr, 16) >> (signal - 1) & 1U) != 0;
    }
    /// Processor time that it has used itself, seconds: how far it has come, however busy the machine is.
    double computed_s() const {
        const std::string stat = readBytes("/proc/" + std::to_string(pid_) + "/stat");
        std::istringstream fields(stat.substr(stat.rfind(')') + 1));
        std::string field;
        for (int n = 3; n < 14; ++n)  // utime is field 14; the name, field 2, ends at the bracket
            fields >> field;
        double ticks = 0;
        fields >> ticks;
        return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
    }
    /// Written so far.
    std::string out() const { return readBytes(outputs_.file("out")); }
    std::string error() const { return readBytes(outputs_.file("err")); }
    Ran wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        EXPECT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
        return {WEXITSTATUS(status), readBytes(outputs_.file("out")), readBytes(outputs_.file("err"))};
    }

private:
    Folder outputs_;
    pid_t pid_ = 0;
};

inline Ran run(const std::vector<std::string>& arguments) {
    return Started(arguments).wait();
}

inline Ran batch(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "--batch");
    return run(arguments);
}

/// The exit code, and what the message must name.
inline void expectRefusal(const std::vector<std::string>& arguments, int exit_code,
                          const std::vector<std::string>& named) {
    const Ran ran = batch(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << ran.err;
    EXPECT_TRUE(ran.out.empty()) << ran.out;
    for (const std::string& word : named)
        EXPECT_NE(ran.err.find(word), std::string::npos) << "'" << word << "' is not in: " << ran.err;
    EXPECT_EQ(ran.err.find("internal error"), std::string::npos) << ran.err;
}

/// A take of a few seconds of real motion, simulated at readings level.
inline void makeTake(const std::string& path, const std::string& seconds = "5") {
    const Ran ran = batch({"simulate", "--motion", kMotion, "--out", path, "--level", "readings",
                           "--duration", seconds, "--rest-seconds", "1"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
}

}  // namespace noctule::test

#define SKIP_WITHOUT_MOTION()                             \
    if (!std::filesystem::exists(noctule::test::kMotion)) \
    GTEST_SKIP() << "install assimp-testmodels for " << noctule::test::kMotion
