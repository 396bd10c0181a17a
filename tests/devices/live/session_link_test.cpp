// SPDX-License-Identifier: Apache-2.0
// What a LiveSession says of its link, event by event.
#include <gtest/gtest.h>

#include "devices/live/live_session.h"
#include "tests/devices/live/fake_device.h"
#include "tests/devices/live/hand_device.h"

namespace noctule {
namespace {

using test::HandDevice;

constexpr int kHandBoards = 2;

Error because(const std::string& what) {
    return {ErrorKind::kDevice, what, "Look at the box"};
}

/// A session that is greeted, and streams for somebody who only looks.
struct Looking {
    Looking() {
        session.connect();
        hand->tell(link::Greeted{test::madeHello(kHandBoards)});
        StreamRequest look;
        look.process = false;
        EXPECT_TRUE(session.begin(look));
        hand->tell(link::Started{});
        hand->tell(*test::madeBlock(0, 600, kHandBoards).sound);
    }
    LinkState link() const { return session.status()->link; }

    HandDevice* hand = new HandDevice;  ///< the session's
    LiveSession session{std::unique_ptr<Device>(hand)};
};

TEST(SessionLink, AStopWhileItIsLostLeavesItLostUntilTheBoxGreetsAgain) {
    Looking looking;
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
    looking.hand->tell(link::Greeted{test::madeHello(kHandBoards)});
    EXPECT_EQ(looking.link(), LinkState::kReady);
}

TEST(SessionLink, FinishWhileItIsLostLeavesItLost) {
    Looking looking;
    looking.hand->tell(link::LinkLost{because("cut")});
    looking.session.finish();
    EXPECT_EQ(looking.link(), LinkState::kLost);
    EXPECT_FALSE(looking.session.status()->trouble) << "of the link the message tells";
    EXPECT_NE(looking.session.status()->last_message.find("cut"), std::string::npos);
}

TEST(SessionLink, ABoxThatHasRestartedIsReadyAgain) {
    Looking looking;
    looking.hand->tell(link::LinkLost{because("cut")});
    looking.hand->tell(link::Greeted{test::madeHello(kHandBoards)});
    looking.hand->tell(link::TakeEnded{because("restarted")});
    EXPECT_EQ(looking.link(), LinkState::kReady);
    EXPECT_EQ(looking.session.status()->trouble->message, "restarted");
}

TEST(SessionLink, ARefusalIsForGood) {
    Looking looking;
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
    hand->tell(link::Greeted{test::madeHello(kHandBoards)});
    ASSERT_TRUE(session.begin({}));
    hand->tell(link::RequestFailed{link::Type::kStart, because("no sound comes")});
    EXPECT_EQ(session.status()->link, LinkState::kReady);
    EXPECT_FALSE(session.status()->stream_is_open);
    EXPECT_EQ(session.finish().trouble->message, "no sound comes");
}

}  // namespace
}  // namespace noctule
