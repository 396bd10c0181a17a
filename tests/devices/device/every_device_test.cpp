// SPDX-License-Identifier: Apache-2.0
// What every kind of device does alike, with the tiny take in all of them.
#include "tests/devices/support/event_log.h"

namespace noctule::test {
namespace {

using namespace std::chrono_literals;

enum class Kind { kTcp, kPty, kReplay };

/// A device and what it talks to.
struct Rig {
    explicit Rig(Kind kind, double speed = 4) {
        if (kind != Kind::kReplay)
            box = std::make_unique<TestBox>(TestBox::Options{.pty = kind == Kind::kPty, .speed = speed});
        device = makeDevice(box ? box->address() : "replay:" + kTinyTake, {speed}).value();
    }
    bool opens() {
        device->open(log.listener());
        return log.waitFor<link::Greeted>();
    }
    bool starts(size_t times = 1) {
        device->start();
        return log.waitFor<link::Started>(times);
    }
    bool stops(size_t times = 1) {
        device->stop();
        return log.waitFor<link::Stopped>(times);
    }

    std::unique_ptr<TestBox> box;
    EventLog log;
    std::unique_ptr<Device> device;  ///< last: gone before what it talks to
};

class EveryDevice : public testing::TestWithParam<Kind> {};

std::string kindName(const testing::TestParamInfo<Kind>& kind) {
    return kind.param == Kind::kTcp ? "Tcp" : kind.param == Kind::kPty ? "Pty" : "Replay";
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryDevice, testing::Values(Kind::kTcp, Kind::kPty, Kind::kReplay),
                         kindName);

TEST_P(EveryDevice, GreetsWithTheSuitAndTellsHowItIs) {
    Rig rig(GetParam());
    ASSERT_TRUE(rig.opens());
    const link::Hello hello = rig.log.last<link::Greeted>().hello;
    EXPECT_EQ(hello.serial, "NB-000777");
    EXPECT_EQ(hello.sample_rate_hz, 150000);
    EXPECT_EQ(toJson(hello.suit), toJson(TakeSound::tiny().hello.suit));
    ASSERT_TRUE(rig.log.waitFor<link::BoxStatus>());
    EXPECT_EQ(rig.log.last<link::BoxStatus>().board_flags, std::vector<uint16_t>(2, link::kBoardConnected));
    EXPECT_EQ(rig.log.count<link::Started>(), 0u);
}

TEST_P(EveryDevice, GivesEverySampleBitForBitUntilItIsStopped) {
    Rig rig(GetParam());
    ASSERT_TRUE(rig.opens());
    ASSERT_TRUE(rig.starts());
    ASSERT_TRUE(rig.log.waitFor<link::SoundBlock>(400));
    ASSERT_TRUE(rig.stops());
    EXPECT_GE(rig.log.expectTinySound(), 400 * 600);
    EXPECT_EQ(rig.log.lostSamples(), 0);
    EXPECT_EQ(rig.device->statistics().lost_samples, 0);
    EXPECT_EQ(rig.log.count<link::TakeEnded>(), 0u);
    if (rig.box) {
        EXPECT_EQ(rig.log.expectTinySound(), rig.box->sampledSamples()) << "stop lost what the box held";
    }
}

TEST_P(EveryDevice, BeginsAgainWithEveryStart) {
    Rig rig(GetParam());
    ASSERT_TRUE(rig.opens());
    for (size_t take = 1; take <= 3; ++take) {
        ASSERT_TRUE(rig.starts(take));
        ASSERT_TRUE(rig.log.waitFor<link::SoundBlock>(take * 20));
        ASSERT_TRUE(rig.stops(take));
        EXPECT_GT(rig.log.expectTinySound(), 0);
    }
}

TEST_P(EveryDevice, ASecondStartFailsAndChangesNothing) {
    Rig rig(GetParam());
    ASSERT_TRUE(rig.opens());
    ASSERT_TRUE(rig.starts());
    rig.device->start();
    ASSERT_TRUE(rig.log.waitFor<link::RequestFailed>());
    EXPECT_EQ(rig.log.last<link::RequestFailed>().type, link::Type::kStart);
    EXPECT_FALSE(rig.log.last<link::RequestFailed>().why.remedy.empty());
    const size_t before = rig.log.count<link::SoundBlock>();
    ASSERT_TRUE(rig.log.waitFor<link::SoundBlock>(before + 20));
    ASSERT_TRUE(rig.stops());
    rig.log.expectTinySound();
    EXPECT_EQ(rig.log.count<link::Started>(), 1u);
}

TEST_P(EveryDevice, AStopWithoutATakeIsNothing) {
    Rig rig(GetParam());
    ASSERT_TRUE(rig.opens());
    rig.device->stop();
    ASSERT_TRUE(rig.starts());
    EXPECT_EQ(rig.log.count<link::Stopped>(), 0u);
}

TEST_P(EveryDevice, AnswersEveryRequest) {
    Rig rig(GetParam());
    ASSERT_TRUE(rig.opens());
    rig.device->identify({1, 500});
    rig.device->set({.pulse_interval_samples = 1500, .enabled_sources = {}, .pulse_cycles = {}, .name = {}});
    const auto answers = [&] {
        return rig.log.count<link::RequestDone>() + rig.log.count<link::RequestFailed>();
    };
    for (int i = 0; i < 500 && answers() < 2; ++i)
        std::this_thread::sleep_for(10ms);
    EXPECT_EQ(answers(), 2u);
    if (GetParam() == Kind::kReplay)
        return;
    EXPECT_EQ(rig.log.count<link::RequestDone>(), 2u);
    ASSERT_TRUE(rig.log.waitFor<link::Greeted>(2)) << "what HELLO says has changed";
    EXPECT_EQ(rig.log.last<link::Greeted>().hello.pulse_interval_samples, 1500);
}

TEST_P(EveryDevice, IsGoneAtOnceAtAnyMoment) {
    for (const auto moment : {0ms, 1ms, 5ms, 20ms, 60ms, 150ms, 300ms}) {
        Rig rig(GetParam());
        rig.device->open(rig.log.listener());
        if (moment > 5ms && rig.log.waitFor<link::Greeted>())
            rig.device->start();
        std::this_thread::sleep_for(moment);
        const int64_t before_ns = steadyNow_ns();
        rig.device.reset();
        EXPECT_LT(steadyNow_ns() - before_ns, 1'000'000'000) << "after " << moment.count() << " ms";
        const size_t events = rig.log.all().size();
        std::this_thread::sleep_for(30ms);
        EXPECT_EQ(rig.log.all().size(), events) << "an event after the end";
    }
    Rig never(GetParam());
    never.device.reset();
}

}  // namespace
}  // namespace noctule::test
