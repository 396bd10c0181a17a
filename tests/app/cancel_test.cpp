// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and a polite kill: exit code 130, no half file, inputs as they were.
#include <chrono>
#include <thread>

#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

using std::chrono::milliseconds;

TEST(Cancel, SimulateLeavesNothing) {
    Folder folder;
    for (const int signal : {SIGINT, SIGTERM}) {
        Started started(
            {"--batch", "simulate", "--rig", "rest", "--duration", "600", "--out", folder.file("t.noctule")});
        for (int i = 0; i < 200 && folder.names().empty(); ++i)  // until it writes
            std::this_thread::sleep_for(milliseconds(20));
        EXPECT_FALSE(folder.names().empty());
        started.send(signal);
        const Ran ran = started.wait();
        EXPECT_EQ(ran.exit_code, 130) << ran.err;
        EXPECT_EQ(folder.names(), std::vector<std::string>{});
    }
}

TEST(Cancel, ProcessLeavesTheTakeAndNoCopy) {
    Folder folder;
    const std::string take = folder.file("t.noctule");
    ASSERT_EQ(batch({"simulate", "--motion", NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh", "--duration",
                     "30", "--level", "readings", "--out", take})
                  .exit_code,
              0);
    const std::string before = readBytes(take);
    for (const bool copy : {false, true}) {
        std::filesystem::create_directory(folder.file("o"));
        std::vector<std::string> arguments{"--batch", "process", take};
        if (copy)
            arguments.insert(arguments.end(), {"--out-dir", folder.file("o")});
        Started started(arguments);
        for (int i = 0; i < 3000 && started.computed_s() < 0.3; ++i)
            std::this_thread::sleep_for(milliseconds(10));
        EXPECT_GE(started.computed_s(), 0.3) << "it was done before it was cancelled";
        started.send(SIGINT);
        const Ran ran = started.wait();
        EXPECT_EQ(ran.exit_code, 130) << ran.err;
        EXPECT_EQ(readBytes(take), before);
        EXPECT_TRUE(std::filesystem::is_empty(folder.file("o")));
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"o", "t.noctule"}));
    }
}

}  // namespace
}  // namespace noctule::test
