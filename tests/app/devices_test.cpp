// SPDX-License-Identifier: Apache-2.0
// What `noctule --batch devices` lists, with a box that answers on loopback.
#include "tests/devices/support/answerer.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

std::vector<std::string> devicesAt(uint16_t port, std::vector<std::string> more) {
    more.insert(more.begin(), {"devices", "--port", std::to_string(port)});
    return more;
}

TEST(Devices, ABoxIsListed) {
    const Answerer box(testAnnouncement());
    const Ran ran = batch(devicesAt(box.port(), {"--wait", "1", "--json"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto listed = ran.json()["devices"];
    ASSERT_GE(listed.size(), 1u);
    EXPECT_EQ(listed[0], (nlohmann::json{{"address", "tcp://127.0.0.1:50123"},
                                         {"name", "Blue suit"},
                                         {"model", "test box"},
                                         {"contact", "answers"},
                                         {"serial", "NB-000777"},
                                         {"boards", 18},
                                         {"sources", 8},
                                         {"sample_rate_hz", 150000},
                                         {"busy", false}}));
    const Ran text = batch(devicesAt(box.port(), {"--wait", "1"}));
    for (const char* word : {"tcp://127.0.0.1:50123", "Blue suit", "NB-000777", "18 boards", "8 sources"})
        EXPECT_NE(text.out.find(word), std::string::npos) << text.out;
}

TEST(Devices, FindingNothingIsNoErrorAndSaysWhatToDo) {
    const Ran json = batch(devicesAt(1, {"--wait", "0.1", "--json"}));
    EXPECT_EQ(json.exit_code, 0) << json.err;
    if (!json.json()["devices"].empty())
        GTEST_SKIP() << "a USB serial port is plugged in";
    const Ran text = batch(devicesAt(1, {"--wait", "0"}));
    EXPECT_EQ(text.exit_code, 0);
    for (const char* word : {"No device", "Switch", "noctule-virtual-suit"})
        EXPECT_NE(text.out.find(word), std::string::npos) << text.out;
    EXPECT_TRUE(text.err.empty()) << text.err;
    EXPECT_EQ(batch(devicesAt(1, {"--wait", "0", "--probe"})).exit_code, 0);
}

TEST(Devices, ItsOptionsAreChecked) {
    expectRefusal({"devices", "--wait", "-1"}, 2, {"--wait"});
    expectRefusal({"devices", "--port", "70000"}, 2, {"--port"});
    expectRefusal({"devices", "tcp://10.0.0.7"}, 2, {"tcp://10.0.0.7"});
}

TEST(Devices, WaitingCanBeCancelled) {
    Started waiting({"--batch", "devices", "--wait", "60", "--port", "1"});
    for (int waited = 0; waited < 1000 && !waiting.catches(SIGINT); ++waited)
        usleep(10'000);
    waiting.send(SIGINT);
    EXPECT_EQ(waiting.wait().exit_code, 130);
}

}  // namespace
}  // namespace noctule::test
