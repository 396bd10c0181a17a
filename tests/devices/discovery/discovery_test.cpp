// SPDX-License-Identifier: Apache-2.0
#include "devices/discovery/discovery.h"

#include <condition_variable>
#include <map>

#include "tests/devices/support/answerer.h"
#include "tests/devices/support/test_box.h"

namespace noctule::test {
namespace {

using Contact = FoundDevice::Contact;
using Devices = std::vector<FoundDevice>;

/// A running discovery and what it told.
class Watch {
public:
    explicit Watch(uint16_t port) {
        discovery =
            std::make_unique<Discovery>(DiscoveryOptions{port, false}, [this](const Devices& devices) {
                const std::lock_guard lock(mutex_);
                devices_ = devices;
                news_.notify_all();
            });
    }
    ~Watch() { discovery.reset(); }
    bool waitFor(const std::function<bool(const Devices&)>& wanted, double seconds) {
        std::unique_lock lock(mutex_);
        return news_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return wanted(devices_); });
    }

    std::unique_ptr<Discovery> discovery;

private:
    std::mutex mutex_;
    std::condition_variable news_;
    Devices devices_;
};

bool none(const Devices& devices) {
    return devices.empty();
}
bool one(const Devices& devices) {
    return devices.size() == 1;
}

TEST(DiscoveryTest, ABoxAppearsChangesAndDisappears) {
    Answerer box(testAnnouncement());
    Watch watch(box.port());
    ASSERT_TRUE(watch.waitFor(one, 2));
    EXPECT_EQ(watch.discovery->found(), (Devices{{"tcp://127.0.0.1:50123", "NB-000777", "Blue suit",
                                                  "test box", 18, 8, 150000, false, Contact::kAnswers}}));
    link::Announcement busy = testAnnouncement();
    busy.busy = true;
    box.announce(busy);
    EXPECT_TRUE(watch.waitFor([](const Devices& devices) { return one(devices) && devices[0].busy; }, 2));
    box.answers(false);
    EXPECT_TRUE(watch.waitFor(none, 6));
    box.answers(true);
    EXPECT_TRUE(watch.waitFor(one, 2)) << "switched on again";
}

TEST(DiscoveryTest, AsksThreeTimesAtOnceThenOnceASecond) {
    Answerer box(testAnnouncement());
    const int64_t before_ns = steadyNow_ns();
    Watch watch(box.port());
    std::this_thread::sleep_for(std::chrono::milliseconds(3000));
    const int questions = box.questions();
    EXPECT_GE(questions, 4);
    EXPECT_LE(questions, 4 + static_cast<double>(steadyNow_ns() - before_ns) * 1e-9 - 0.6);
}

TEST(DiscoveryTest, EndsAtOnce) {
    Answerer box(testAnnouncement());
    for (int i = 0; i < 10; ++i) {
        const int64_t before_ns = steadyNow_ns();
        {
            const Discovery discovery({box.port(), true});
            std::this_thread::sleep_for(std::chrono::milliseconds(i * 5));
        }
        EXPECT_LT(steadyNow_ns() - before_ns, 1'000'000'000);
    }
}

TEST(DiscoveryTest, ANamedTerminalIsProbedOnWish) {
    auto box = std::make_unique<TestBox>(TestBox::Options{.pty = true});
    Watch watch(1);
    ASSERT_TRUE(watch.discovery->probe(box->address()));
    ASSERT_TRUE(watch.waitFor(
        [](const Devices& devices) { return one(devices) && devices[0].contact == Contact::kAnswers; }, 5));
    const FoundDevice found = watch.discovery->found().at(0);
    EXPECT_EQ(found.address, box->address());
    EXPECT_EQ(found.serial, "NB-000777");
    EXPECT_EQ(found.boards, 2);
    EXPECT_EQ(found.sources, 2);
    box.reset();
    EXPECT_TRUE(watch.waitFor(none, 5)) << "its path is gone";
}

void waitUntilSettled(const Discovery& discovery) {
    for (int i = 0; i < 500 && !discovery.isSettled(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(discovery.isSettled());
}

TEST(DiscoveryTest, ItIsSettledWhenEveryProbeHasEnded) {
    const TestBox box({.pty = true}), mute({.pty = true, .answers = false});
    Discovery discovery({1, false});
    waitUntilSettled(discovery);
    EXPECT_TRUE(discovery.found().empty());
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(discovery.probe(box.address()));
        ASSERT_TRUE(discovery.probe(mute.address()));
        ASSERT_TRUE(discovery.probe(mute.address())) << "twice is once";
        EXPECT_FALSE(discovery.isSettled());
        waitUntilSettled(discovery);
        std::map<std::string, Contact> contacts;
        for (const FoundDevice& device : discovery.found())
            contacts[device.address] = device.contact;
        EXPECT_EQ(contacts, (std::map<std::string, Contact>{{box.address(), Contact::kAnswers},
                                                            {mute.address(), Contact::kSilent}}));
    }
}

TEST(DiscoveryTest, AProbeThatNobodyAnswersEndsSilent) {
    TestBox box({.pty = true, .answers = false});
    Watch watch(1);
    const int64_t before_ns = steadyNow_ns();
    ASSERT_TRUE(watch.discovery->probe(box.address()));
    ASSERT_TRUE(watch.waitFor(
        [](const Devices& devices) { return one(devices) && devices[0].contact == Contact::kSilent; }, 5));
    EXPECT_GT(steadyNow_ns() - before_ns, 1'300'000'000) << "a box is asked twice";
    EXPECT_FALSE(watch.discovery->probe("ttyACM0"));
}

}  // namespace
}  // namespace noctule::test
