// SPDX-License-Identifier: Apache-2.0
#include "devices/discovery/found_list.h"

#include <gtest/gtest.h>

#include "tests/devices/support/answerer.h"

namespace noctule::test {
namespace {

constexpr int64_t kListSecond_ns = 1'000'000'000;

TEST(FoundListTest, ABoxComesStaysAndGoes) {
    FoundList list;
    EXPECT_TRUE(list.announced(testAnnouncement(), "10.0.0.7", 0));
    EXPECT_EQ(list.devices(),
              (std::vector<FoundDevice>{{"tcp://10.0.0.7:50123", "NB-000777", "Blue suit", "test box", 18, 8,
                                         150000, false, FoundDevice::Contact::kAnswers}}));
    EXPECT_FALSE(list.announced(testAnnouncement(), "10.0.0.7", 3 * kListSecond_ns));
    EXPECT_FALSE(list.forgetSilent(6 * kListSecond_ns));
    EXPECT_TRUE(list.forgetSilent(7 * kListSecond_ns));
    EXPECT_TRUE(list.devices().empty());
}

TEST(FoundListTest, WhatItSaysMayChange) {
    FoundList list;
    list.announced(testAnnouncement(), "10.0.0.7", 0);
    link::Announcement busy = testAnnouncement();
    busy.busy = true;
    EXPECT_TRUE(list.announced(busy, "10.0.0.7", 0));
    EXPECT_TRUE(list.devices().at(0).busy);
}

TEST(FoundListTest, SeveralAddressesOfOneComputerAreOneBox) {
    FoundList list;
    list.announced(testAnnouncement(), "10.0.0.7", 0);
    EXPECT_FALSE(list.announced(testAnnouncement(), "192.168.1.7", 0)) << "the address changes without need";
    EXPECT_TRUE(list.announced(testAnnouncement(), "127.0.0.1", 0));
    EXPECT_EQ(list.devices().size(), 1u);
    EXPECT_EQ(list.devices().at(0).address, "tcp://127.0.0.1:50123");
    list.announced(testAnnouncement(), "192.168.1.7", 3 * kListSecond_ns);
    EXPECT_TRUE(list.forgetSilent(5 * kListSecond_ns));
    EXPECT_EQ(list.devices().at(0).address, "tcp://192.168.1.7:50123");
}

TEST(FoundListTest, BoxesOfOneSerialNumberDifferByPort) {
    FoundList list;
    link::Announcement other = testAnnouncement();
    other.tcp_port = 50124;
    list.announced(testAnnouncement(), "127.0.0.1", 0);
    EXPECT_TRUE(list.announced(other, "127.0.0.1", 0));
    EXPECT_EQ(list.devices().size(), 2u);
}

FoundDevice usbPort(const std::string& address) {
    FoundDevice port;
    port.address = address;
    port.contact = FoundDevice::Contact::kNotAsked;
    return port;
}

TEST(FoundListTest, PortsComeGoAndKeepWhatTheySaid) {
    FoundList list;
    const std::vector<FoundDevice> ports = {usbPort("serial:///dev/ttyACM0"),
                                            usbPort("serial:///dev/ttyACM1")};
    EXPECT_TRUE(list.setPorts(ports));
    EXPECT_FALSE(list.setPorts(ports));
    EXPECT_TRUE(list.probing("serial:///dev/ttyACM1"));
    link::Hello hello;
    hello.serial = "NB-7";
    hello.suit.boards.resize(18);
    EXPECT_TRUE(list.probed("serial:///dev/ttyACM1", hello));
    EXPECT_FALSE(list.setPorts(ports));
    EXPECT_EQ(list.devices().at(0).contact, FoundDevice::Contact::kNotAsked);
    EXPECT_EQ(list.devices().at(1).serial, "NB-7");
    EXPECT_EQ(list.devices().at(1).boards, 18);
    EXPECT_TRUE(list.setPorts({ports[0]}));
    EXPECT_FALSE(list.probed("serial:///dev/ttyACM1", hello)) << "it was unplugged meanwhile";
    EXPECT_EQ(list.devices().size(), 1u);
}

}  // namespace
}  // namespace noctule::test
