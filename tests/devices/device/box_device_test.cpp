// SPDX-License-Identifier: Apache-2.0
// What only a link to a box can suffer, over TCP and over a pseudo-terminal.
#include "tests/devices/support/event_log.h"

namespace noctule::test {
namespace {

using namespace std::chrono_literals;

class BoxDevice : public testing::TestWithParam<bool> {
protected:
    void begin(TestBox::Options options = {}) {
        options.pty = GetParam();
        box = std::make_unique<TestBox>(options);
        device = makeDevice(box->address()).value();
        device->open(log.listener());
    }
    bool streams() {
        const size_t before = log.count<link::Started>();
        if (!log.waitFor<link::Greeted>())
            return false;
        device->start();
        return log.waitFor<link::Started>(before + 1);
    }

    std::unique_ptr<TestBox> box;
    EventLog log;
    std::unique_ptr<Device> device;
};

INSTANTIATE_TEST_SUITE_P(Wires, BoxDevice, testing::Bool(),
                         [](const auto& pty) { return pty.param ? "Pty" : "Tcp"; });

TEST_P(BoxDevice, GoesOnAfterACutAndTheHoleIsAGap) {
    begin();
    ASSERT_TRUE(streams());
    ASSERT_TRUE(log.waitFor<link::SoundBlock>(40));
    box->cut();
    ASSERT_TRUE(log.waitFor<link::LinkLost>());
    ASSERT_TRUE(log.waitFor<link::Resumed>());
    const size_t before = log.count<link::SoundBlock>();
    ASSERT_TRUE(log.waitFor<link::SoundBlock>(before + 40));
    device->stop();
    ASSERT_TRUE(log.waitFor<link::Stopped>());
    EXPECT_EQ(log.expectTinySound(), box->sampledSamples());
    EXPECT_EQ(log.count<link::Started>(), 1u);
    EXPECT_EQ(device->statistics().reconnections, 1);
    EXPECT_EQ(device->statistics().lost_samples, log.lostSamples());
}

TEST_P(BoxDevice, ARestartedBoxEndsTheTakeAndCanStartAnother) {
    begin();
    ASSERT_TRUE(streams());
    ASSERT_TRUE(log.waitFor<link::SoundBlock>(20));
    box->restart();
    ASSERT_TRUE(log.waitFor<link::TakeEnded>());
    EXPECT_NE(log.last<link::TakeEnded>().why.message.find(box->address()), std::string::npos);
    ASSERT_TRUE(streams());
    ASSERT_TRUE(log.waitFor<link::SoundBlock>(40));
}

TEST_P(BoxDevice, LooksThroughGarbage) {
    link::Bytes garbage;
    for (int i = 0; i < 5000; ++i)
        garbage.push_back(static_cast<uint8_t>(i * 37 + i / 256));
    garbage.insert(garbage.end(), {'N', 'C', 'T', 'L', 1, 3});
    begin({.garbage = garbage});
    ASSERT_TRUE(streams());
    ASSERT_TRUE(log.waitFor<link::SoundBlock>(20));
    device->stop();
    ASSERT_TRUE(log.waitFor<link::Stopped>());
    EXPECT_EQ(log.expectTinySound(), box->sampledSamples());
    EXPECT_GT(device->statistics().frames.skipped_bytes, 4000);
}

TEST_P(BoxDevice, ABoxThatStandsStillIsStalledThenFlowing) {
    begin();
    ASSERT_TRUE(streams());
    box->freeze(true);
    ASSERT_TRUE(log.waitFor<link::Stalled>());
    box->freeze(false);
    ASSERT_TRUE(log.waitFor<link::Flowing>());
    EXPECT_EQ(log.count<link::LinkLost>(), 0u);
}

TEST_P(BoxDevice, ASilentLinkIsLostAndFoundAgain) {
    begin();
    ASSERT_TRUE(streams());
    box->freeze(true);
    ASSERT_TRUE(log.waitFor<link::LinkLost>());
    EXPECT_EQ(log.count<link::Stalled>(), 1u);
    box->freeze(false);
    ASSERT_TRUE(log.waitFor<link::Resumed>());
    device->stop();
    ASSERT_TRUE(log.waitFor<link::Stopped>());
    EXPECT_EQ(log.expectTinySound(), box->sampledSamples());
}

TEST_P(BoxDevice, ARefusalSaysThatNobodyAnswers) {
    begin({.answers = false});
    ASSERT_TRUE(log.waitFor<link::Refused>());
    const Error why = log.last<link::Refused>().why;
    EXPECT_EQ(why.kind, ErrorKind::kDevice);
    EXPECT_NE(why.message.find(box->address()), std::string::npos) << why.text();
    EXPECT_FALSE(why.remedy.empty());
    device->start();
    EXPECT_TRUE(log.waitFor<link::RequestFailed>());
}

TEST_P(BoxDevice, ItsEndStopsTheBox) {
    begin();
    ASSERT_TRUE(streams());
    device.reset();
    for (int i = 0; i < 200 && box->streaming(); ++i)
        std::this_thread::sleep_for(10ms);
    EXPECT_FALSE(box->streaming());
}

TEST_P(BoxDevice, HearsTheIdentifiedBoardAtTheBox) {
    begin();
    ASSERT_TRUE(log.waitFor<link::Greeted>());
    device->identify({1, 250});
    ASSERT_TRUE(log.waitFor<link::RequestDone>());
    const auto events = box->events();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(std::get<link::IdentifyWanted>(events[0]).identify, (link::Identify{1, 250}));
}

std::string refusalOf(const std::string& address) {
    EventLog log;
    const auto device = makeDevice(address).value();
    device->open(log.listener());
    EXPECT_TRUE(log.waitFor<link::Refused>()) << address;
    const Error why = log.last<link::Refused>().why;
    EXPECT_EQ(why.kind, ErrorKind::kDevice);
    EXPECT_NE(why.message.find(address), std::string::npos) << why.text();
    EXPECT_FALSE(why.remedy.empty());
    EXPECT_EQ(log.all().size(), 1u);
    return why.text();
}

TEST(NobodyThere, IsRefusedInWords) {
    std::string closed_port;
    {
        const TcpBoxStream gone;
        closed_port = gone.address();
    }
    EXPECT_NE(refusalOf(closed_port).find("refused"), std::string::npos);
    EXPECT_NE(refusalOf("serial:///dev/ttyNoSuchPort").find("devices"), std::string::npos);
    refusalOf("serial:///dev/null");
    refusalOf("tcp://no-such-host.invalid:41941");
}

TEST(NobodyThere, TheEndDoesNotWaitForAConnection) {
    for (const char* address : {"tcp://no-such-host.invalid", "tcp://192.0.2.1", "tcp://240.0.0.1"})
        for (const auto moment : {0ms, 10ms, 100ms}) {
            EventLog log;
            auto device = makeDevice(address).value();
            device->open(log.listener());
            std::this_thread::sleep_for(moment);
            const int64_t before_ns = steadyNow_ns();
            device.reset();
            EXPECT_LT(steadyNow_ns() - before_ns, 1'000'000'000) << address;
        }
}

TEST(NobodyThere, TheEndDoesNotWaitForAPause) {
    auto box = std::make_unique<TestBox>(TestBox::Options{});
    EventLog log;
    auto device = makeDevice(box->address()).value();
    device->open(log.listener());
    ASSERT_TRUE(log.waitFor<link::Greeted>());
    box.reset();
    ASSERT_TRUE(log.waitFor<link::LinkLost>());
    ASSERT_TRUE(log.waitFor<link::ConnectWanted>(2)) << "it tries again and again";
    EXPECT_EQ(log.count<link::Refused>(), 0u);
    const int64_t before_ns = steadyNow_ns();
    device.reset();
    EXPECT_LT(steadyNow_ns() - before_ns, 1'000'000'000);
}

TEST(NobodyThere, ABusyBoxTurnsTheSecondStudioAway) {
    TestBox box({});
    EventLog log;
    const auto device = makeDevice(box.address()).value();
    device->open(log.listener());
    ASSERT_TRUE(log.waitFor<link::Greeted>());
    EXPECT_NE(refusalOf(box.address()).find("another program"), std::string::npos);
}

}  // namespace
}  // namespace noctule::test
