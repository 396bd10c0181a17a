// SPDX-License-Identifier: Apache-2.0
// Stalls, lost links, and what becomes of the take.
#include "tests/devices/driver_box/scripted_box.h"

namespace noctule::link {
namespace {

using State = StudioConversation::State;

TEST(Studio, StallsAfterHalfASecondAndIsLostAfterThree) {
    Scripted link;
    link.startTake();
    link.wait_ms(499);
    EXPECT_EQ(countOf<Stalled>(link.events), 0u);
    link.wait_ms(1);
    EXPECT_EQ(countOf<Stalled>(link.events), 1u);
    link.adc(600);
    EXPECT_EQ(countOf<Flowing>(link.events), 1u);
    link.wait_ms(2999);
    EXPECT_EQ(countOf<LinkLost>(link.events), 0u);
    link.wait_ms(1);
    EXPECT_EQ(countOf<LinkLost>(link.events), 1u);
    EXPECT_EQ(countOf<Stalled>(link.events), 2u);
    EXPECT_TRUE(link.studio.takeIsOpen());
}

TEST(Studio, ReconnectsAfterLongerAndLongerPauses) {
    Scripted link;
    link.startTake();
    link.studio.closed(link.now_ns);
    int attempt = 0;
    for (const int64_t pause_ms : {500, 1000, 2000, 4000, 4000, 4000}) {
        link.wait_ms(pause_ms - 1);
        EXPECT_EQ(countOf<ConnectWanted>(link.events), static_cast<size_t>(attempt));
        link.wait_ms(1);
        ASSERT_EQ(countOf<ConnectWanted>(link.events), static_cast<size_t>(++attempt));
        EXPECT_EQ(eventsOf<ConnectWanted>(link.events).back().attempt, attempt);
        link.studio.closed(link.now_ns);
        link.collect();
    }
    EXPECT_TRUE(link.studio.takeIsOpen());
    EXPECT_EQ(countOf<LinkLost>(link.events), 1u);
}

TEST(Studio, ABoxThatWentOnResumesTheTake) {
    Scripted link;
    link.startTake();
    link.studio.closed(link.now_ns);
    link.wait_ms(500);
    link.open();
    EXPECT_EQ(link.sent.back(), (std::pair{Type::kQuery, uint32_t{0}}));
    link.hello(true);
    EXPECT_EQ(countOf<Resumed>(link.events), 1u);
    link.adc(90'000);
    EXPECT_EQ(eventsOf<Gap>(link.events), (std::vector<Gap>{{600, 89'400, GapReason::kLink}}));
    EXPECT_EQ(countOf<TakeEnded>(link.events), 0u);
    EXPECT_EQ(link.sentOf(Type::kStart), 1u);
}

TEST(Studio, HalfAFrameOfTheOldConnectionIsForgotten) {
    Scripted link;
    link.startTake();
    const Bytes frame =
        encodeFrame(static_cast<uint8_t>(Type::kAdc), link.sequence, toPayload(soundBlock(600, 600, 2)));
    link.studio.receive(ByteView(frame).first(1000), link.now_ns);
    link.studio.closed(link.now_ns);
    link.wait_ms(500);
    link.open();
    link.hello(true);
    EXPECT_EQ(countOf<Resumed>(link.events), 1u);
}

TEST(Studio, AnotherBoxOrARestartedOneEndsTheTake) {
    struct Case {
        bool streaming;
        const char* serial;
        const char* said;
    };
    for (const Case& one : {Case{false, "NB-000777", "restarted"}, Case{true, "NB-000778", "another box"}}) {
        Scripted link;
        link.startTake();
        link.studio.closed(link.now_ns);
        link.wait_ms(500);
        link.open();
        link.hello(one.streaming, one.serial);
        ASSERT_EQ(countOf<TakeEnded>(link.events), 1u);
        EXPECT_NE(eventsOf<TakeEnded>(link.events)[0].why.message.find(one.said), std::string::npos);
        EXPECT_EQ(countOf<Resumed>(link.events), 0u);
        EXPECT_EQ(link.studio.state(), State::kIdle);
        EXPECT_FALSE(link.studio.takeIsOpen());
    }
}

TEST(Studio, AnUnaskedHelloOfARestartedOrAnotherBoxEndsTheTake) {
    for (const bool restarted : {true, false}) {
        Scripted link;
        link.startTake();
        link.hello(true);
        EXPECT_EQ(countOf<TakeEnded>(link.events), 0u);
        restarted ? link.hello(false) : link.hello(true, "NB-000778");
        EXPECT_EQ(countOf<TakeEnded>(link.events), 1u);
        EXPECT_EQ(link.studio.state(), State::kIdle);
    }
}

TEST(Studio, ASilentIdleBoxIsReconnected) {
    Scripted link;
    link.open();
    link.hello();
    link.wait_ms(2999);
    EXPECT_EQ(countOf<LinkLost>(link.events), 0u);
    link.wait_ms(1);
    EXPECT_EQ(countOf<LinkLost>(link.events), 1u);
    link.wait_ms(500);
    EXPECT_EQ(countOf<ConnectWanted>(link.events), 1u);
    link.studio.hangUp();
    link.wait_ms(10'000);
    EXPECT_EQ(countOf<ConnectWanted>(link.events), 1u);
}

}  // namespace
}  // namespace noctule::link
