// SPDX-License-Identifier: Apache-2.0
// What a LiveSession says of its link, event by event.
#include <gtest/gtest.h>

#include "tests/devices/live/hand_device.h"

namespace noctule {
namespace {

using test::HandDevice;
using test::LookedAt;

Error because(const std::string& what) {
    return {ErrorKind::kDevice, what, "Look at the box"};
}

TEST(SessionLink, AStopWhileItIsLostLeavesItLostUntilTheBoxGreetsAgain) {
    LookedAt looking;
    looking.hear(0, 600);
    EXPECT_EQ(looking.link(), LinkState::kStreaming);
    looking.hand->tell(link::LinkLost{because("cut")});
    looking.session.stop();
    EXPECT_EQ(looking.hand->stops, 1);
    EXPECT_EQ(looking.link(), LinkState::kLost);
    looking.hand->tell(link::Stopped{});
    EXPECT_FALSE(looking.session.status()->stream_is_open);
    EXPECT_EQ(looking.link(), LinkState::kLost);
    looking.session.finish();
    EXPECT_EQ(looking.link(), LinkState::kLost);
    EXPECT_FALSE(looking.session.begin({})) << "nobody would hear it";
    looking.hand->tell(link::Greeted{test::madeHello(LookedAt::kBoards)});
    EXPECT_EQ(looking.link(), LinkState::kReady);
}

TEST(SessionLink, FinishWhileItIsLostLeavesItLost) {
    LookedAt looking;
    looking.hear(0, 600);
    looking.hand->tell(link::LinkLost{because("cut")});
    looking.session.finish();
    EXPECT_EQ(looking.link(), LinkState::kLost);
    EXPECT_FALSE(looking.session.status()->trouble) << "of the link the message tells";
    EXPECT_NE(looking.session.status()->last_message.find("cut"), std::string::npos);
}

TEST(SessionLink, ABoxThatHasRestartedIsReadyAgain) {
    LookedAt looking;
    looking.hear(0, 600);
    looking.hand->tell(link::LinkLost{because("cut")});
    looking.hand->tell(link::Greeted{test::madeHello(LookedAt::kBoards)});
    looking.hand->tell(link::TakeEnded{because("restarted")});
    EXPECT_EQ(looking.link(), LinkState::kReady);
    EXPECT_EQ(looking.session.status()->trouble->message, "restarted");
}

TEST(SessionLink, ARefusalIsForGood) {
    LookedAt looking;
    looking.hear(0, 600);
    looking.hand->tell(link::LinkLost{because("cut")});
    looking.hand->tell(link::Refused{because("another protocol")});
    looking.hand->tell(link::TakeEnded{because("closed while recording")});
    EXPECT_EQ(looking.link(), LinkState::kRefused);
    EXPECT_EQ(looking.session.status()->trouble->message, "another protocol");
    looking.session.finish();
    EXPECT_EQ(looking.link(), LinkState::kRefused);
}

TEST(SessionLink, ARefusalNeverLooksReadyForAMoment) {
    bool looked_ready = false;
    for (int round = 0; round < 100; ++round) {
        auto* hand = new HandDevice;
        LiveSession session{std::unique_ptr<Device>(hand)};
        session.connect();
        std::atomic<bool> told{false};
        std::thread reader([&] {
            while (!told)
                looked_ready = looked_ready || session.status()->link == LinkState::kReady;
        });
        hand->tell(link::Refused{because("nobody there")});
        told = true;
        reader.join();
        ASSERT_TRUE(session.status()->trouble);
        EXPECT_EQ(session.status()->link, LinkState::kRefused);
    }
    EXPECT_FALSE(looked_ready);
}

TEST(SessionLink, AStartThatFailsIsToldAndLeavesItReady) {
    auto* hand = new HandDevice;
    LiveSession session{std::unique_ptr<Device>(hand)};
    session.connect();
    hand->tell(link::Greeted{test::madeHello(LookedAt::kBoards)});
    ASSERT_TRUE(session.begin({}));
    hand->tell(link::RequestFailed{link::Type::kStart, because("no sound comes")});
    EXPECT_EQ(session.status()->link, LinkState::kReady);
    EXPECT_FALSE(session.status()->stream_is_open);
    EXPECT_EQ(session.finish().trouble->message, "no sound comes");
}

}  // namespace
}  // namespace noctule
