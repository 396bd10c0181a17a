// SPDX-License-Identifier: Apache-2.0
#include "devices/device/address.h"

#include <gtest/gtest.h>

#include <vector>

#include "devices/device/device.h"

namespace noctule {
namespace {

TEST(DeviceAddressTest, EverySpellingGivesTheSameText) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"tcp://10.0.0.7", "tcp://10.0.0.7:41941"},
        {"tcp://10.0.0.7:41941/", "tcp://10.0.0.7:41941"},
        {"tcp://suit-1.local:5000", "tcp://suit-1.local:5000"},
        {"tcp://[fe80::1%eth0]:5000", "tcp://[fe80::1%eth0]:5000"},
        {"tcp://[::1]", "tcp://[::1]:41941"},
        {"serial:///dev/ttyACM0", "serial:///dev/ttyACM0"},
        {"replay:/takes/a walk_001.noctule", "replay:/takes/a walk_001.noctule"},
        {"replay:walk.noctule", "replay:walk.noctule"},
    };
    for (const auto& [typed, full] : cases) {
        const auto address = readDeviceAddress(typed);
        ASSERT_TRUE(address) << typed << ": " << address.error().text();
        EXPECT_EQ(address->text(), full);
        const auto device = makeDevice(typed);
        ASSERT_TRUE(device);
        EXPECT_EQ((*device)->address(), full);
    }
}

TEST(DeviceAddressTest, ErrorsNameTheAddressAndWhatAddressesLookLike) {
    for (const char* bad :
         {"", "10.0.0.7", "tcp://", "tcp://:41941", "tcp://host:", "tcp://host:0", "tcp://host:65536",
          "tcp://host:12x", "tcp://ho st", "tcp://a/b", "tcp://::1", "tcp://[::1", "tcp://[::1]x",
          "tcp://[host]", "serial:/dev/ttyACM0", "serial://ttyACM0", "serial:///", "replay:", "http://a"}) {
        const auto device = makeDevice(bad);
        ASSERT_FALSE(device) << bad;
        EXPECT_EQ(device.error().kind, ErrorKind::kUsage);
        EXPECT_NE(device.error().message.find("'" + std::string(bad) + "'"), std::string::npos);
        for (const char* example : {"tcp://10.0.0.7:41941", "serial:///dev/ttyACM0", "replay:"})
            EXPECT_NE(device.error().remedy.find(example), std::string::npos) << device.error().text();
    }
}

TEST(DeviceAddressTest, TheSpeedOfAReplayIsChecked) {
    for (const double speed :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(makeDevice("replay:walk.noctule", {speed}));
}

}  // namespace
}  // namespace noctule
