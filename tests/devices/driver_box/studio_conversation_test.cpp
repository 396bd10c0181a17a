// SPDX-License-Identifier: Apache-2.0
// The studio's side against bytes written by hand, to the millisecond.
#include "devices/driver_box/studio_conversation.h"

#include "devices/driver_box/crc32.h"
#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {
namespace {

using State = StudioConversation::State;

/// A box that says only what a test lets it say.
struct Scripted {
    StudioConversation studio{"here"};
    FrameReader reader;
    std::vector<StudioEvent> events;
    std::vector<std::pair<Type, uint32_t>> sent;
    int64_t now_ns = kSecond_ns;
    uint32_t sequence = 0;

    void collect() {
        for (StudioEvent& event : studio.takeEvents())
            events.push_back(std::move(event));
        const Bytes bytes = studio.takeBytes();
        reader.push(bytes, now_ns, [&](const Frame& frame) {
            sent.emplace_back(static_cast<Type>(frame.header.type), frame.header.sequence);
        });
    }
    void say(Type type, const Bytes& payload) {
        studio.receive(encodeFrame(static_cast<uint8_t>(type), sequence++, payload), now_ns);
        collect();
    }
    void wait_ms(int64_t duration_ms) {
        for (int64_t i = 0; i < duration_ms; ++i) {
            now_ns += kMillisecond_ns;
            studio.tick(now_ns);
            collect();
        }
    }
    /// Keeps an idle link alive.
    void waitWithStatus_ms(int64_t duration_ms) {
        for (; duration_ms > 0; duration_ms -= 1000) {
            say(Type::kStatus, status());
            wait_ms(std::min<int64_t>(duration_ms, 1000));
        }
    }
    static Bytes status(int64_t sample = 0) {
        BoxStatus status;
        status.sample = sample;
        status.board_flags = {1, 1};
        return toPayload(status);
    }
    void hello(bool streaming = false, const std::string& serial = "NB-000777") {
        Hello hello = testHello(serial);
        hello.streaming = streaming;
        say(Type::kHello, toPayload(hello));
    }
    void open() {
        sequence = 0;
        reader.restart();
        studio.opened(now_ns);
        collect();
    }
    void ack(uint32_t request, Code code = Code::kOk) { say(Type::kAck, toPayload(Ack{request, code, ""})); }
    void adc(int64_t first_sample, int samples = 600) {
        say(Type::kAdc, toPayload(soundBlock(first_sample, samples, 2)));
    }
    void startTake() {
        open();
        hello();
        studio.start(now_ns);
        collect();
        ack(sent.back().second);
        adc(0);
    }
    size_t sentOf(Type type) const {
        return static_cast<size_t>(
            std::count_if(sent.begin(), sent.end(), [&](const auto& one) { return one.first == type; }));
    }
};

TEST(Studio, AsksEveryHalfSecondAndGivesUpAfterThree) {
    Scripted link;
    link.open();
    EXPECT_EQ(link.sent, (std::vector<std::pair<Type, uint32_t>>{{Type::kQuery, 0}}));
    link.wait_ms(499);
    EXPECT_EQ(link.sentOf(Type::kQuery), 1u);
    link.wait_ms(1);
    EXPECT_EQ(link.sentOf(Type::kQuery), 2u);
    link.wait_ms(2499);
    EXPECT_EQ(link.sentOf(Type::kQuery), 6u);
    EXPECT_TRUE(eventsOf<Refused>(link.events).empty());
    link.wait_ms(1);
    ASSERT_EQ(countOf<Refused>(link.events), 1u);
    EXPECT_NE(eventsOf<Refused>(link.events)[0].why.message.find("here"), std::string::npos);
    EXPECT_EQ(link.studio.state(), State::kClosed);
}

TEST(Studio, PingsEveryTwoSecondsAndMeasuresTheWay) {
    Scripted link;
    link.open();
    link.hello();
    link.waitWithStatus_ms(7000);
    EXPECT_EQ(link.sentOf(Type::kPing), 3u);
    Bytes payload;
    WireWriter(payload).number(static_cast<uint64_t>(link.now_ns - 3 * kMillisecond_ns));
    link.say(Type::kPong, payload);
    EXPECT_EQ(link.studio.statistics().round_trip_ns, 3 * kMillisecond_ns);
    EXPECT_EQ(countOf<BoxStatus>(link.events), 7u);
    EXPECT_EQ(countOf<LinkLost>(link.events), 0u);
}

TEST(Studio, RefusesOtherVersionsAndProtocols) {
    Scripted version;
    version.open();
    Bytes frame = encodeFrame(0x01, 0, bytesOf("{}"));
    frame[4] = 2;
    Bytes head(frame.begin(), frame.begin() + 16);
    WireWriter(head).number(crc32(head));
    std::copy(head.begin(), head.end(), frame.begin());
    version.studio.receive(frame, version.now_ns);
    version.collect();
    ASSERT_EQ(countOf<Refused>(version.events), 1u);
    EXPECT_NE(eventsOf<Refused>(version.events)[0].why.message.find("version 2"), std::string::npos);

    Scripted protocol;
    protocol.open();
    protocol.say(Type::kHello, bytesOf(R"({"protocol":2,"serial":"x"})"));
    ASSERT_EQ(countOf<Refused>(protocol.events), 1u);
    EXPECT_NE(eventsOf<Refused>(protocol.events)[0].why.message.find("protocol 2"), std::string::npos);
}

TEST(Studio, AHelloThatCannotBeReadIsNamedWhenItGivesUp) {
    Scripted link;
    link.open();
    link.say(Type::kHello, bytesOf(R"({"protocol":1,"serial":"x"})"));
    link.wait_ms(3000);
    ASSERT_EQ(countOf<Refused>(link.events), 1u);
    EXPECT_NE(eventsOf<Refused>(link.events)[0].why.message.find("sample_rate_hz"), std::string::npos);
}

TEST(Studio, StartIsRepeatedTwiceThenFails) {
    Scripted link;
    link.open();
    link.hello();
    link.studio.start(link.now_ns);
    link.wait_ms(2999);
    EXPECT_EQ(link.sentOf(Type::kStart), 3u);
    EXPECT_EQ(countOf<RequestFailed>(link.events), 0u);
    link.wait_ms(1);
    ASSERT_EQ(countOf<RequestFailed>(link.events), 1u);
    EXPECT_EQ(eventsOf<RequestFailed>(link.events)[0].type, Type::kStart);
    EXPECT_EQ(link.sentOf(Type::kStart), 3u);
}

TEST(Studio, AnAckOfAnyRepeatAnswers) {
    Scripted link;
    link.open();
    link.hello();
    link.studio.identify({1, 500}, link.now_ns);
    link.collect();
    const uint32_t first = link.sent.back().second;
    link.wait_ms(1000);
    EXPECT_EQ(link.sentOf(Type::kIdentify), 2u);
    link.ack(first);
    EXPECT_EQ(countOf<RequestDone>(link.events), 1u);
    link.ack(link.sent.back().second);
    EXPECT_EQ(countOf<RequestDone>(link.events), 1u);
    link.waitWithStatus_ms(2500);
    EXPECT_EQ(link.sentOf(Type::kIdentify), 2u);
}

TEST(Studio, RefusedRequestsSayWhy) {
    Scripted link;
    link.open();
    link.hello();
    link.studio.set(Settings{1100, std::nullopt, std::nullopt, std::nullopt}, link.now_ns);
    link.collect();
    link.ack(link.sent.back().second, Code::kNotNow);
    ASSERT_EQ(countOf<RequestFailed>(link.events), 1u);
    EXPECT_NE(eventsOf<RequestFailed>(link.events)[0].why.message.find("not now"), std::string::npos);
    link.studio.start(link.now_ns);
    link.collect();
    link.ack(link.sent.back().second, Code::kHardwareFault);
    ASSERT_EQ(countOf<RequestFailed>(link.events), 2u);
    EXPECT_EQ(link.studio.state(), State::kIdle);
    EXPECT_FALSE(link.studio.takeIsOpen());
}

TEST(Studio, SetAsksForTheNewHello) {
    Scripted link;
    link.open();
    link.hello();
    link.studio.set(Settings{1100, std::nullopt, std::nullopt, std::nullopt}, link.now_ns);
    link.collect();
    link.ack(link.sent.back().second);
    EXPECT_EQ(link.sent.back().first, Type::kQuery);
    link.hello();
    EXPECT_EQ(countOf<Greeted>(link.events), 1u);
    link.hello(false, "NB-000778");
    EXPECT_EQ(countOf<Greeted>(link.events), 2u);
}

TEST(Studio, SoundMustComeWithinASecondOfTheAck) {
    Scripted link;
    link.open();
    link.hello();
    link.studio.start(link.now_ns);
    link.collect();
    link.ack(link.sent.back().second);
    link.wait_ms(999);
    EXPECT_EQ(countOf<RequestFailed>(link.events), 0u);
    link.wait_ms(1);
    EXPECT_EQ(countOf<RequestFailed>(link.events), 1u);
    EXPECT_EQ(countOf<Started>(link.events), 0u);
    // It may stream by now: the next START clears that first.
    link.studio.start(link.now_ns);
    link.collect();
    EXPECT_EQ(link.sent.back().first, Type::kStop);
    link.ack(link.sent.back().second);
    EXPECT_EQ(link.sent.back().first, Type::kStart);
}

TEST(Studio, SoundBeforeALostAckCounts) {
    Scripted link;
    link.open();
    link.hello();
    link.studio.start(link.now_ns);
    link.adc(0);
    EXPECT_EQ(countOf<Started>(link.events), 1u);
    EXPECT_EQ(countOf<AdcBlock>(link.events), 1u);
    link.wait_ms(400);
    EXPECT_EQ(link.sentOf(Type::kStart), 1u);
    EXPECT_EQ(link.studio.state(), State::kStreaming);
}

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

TEST(Studio, TellsWhoLostTheSound) {
    Scripted link;
    link.startTake();
    link.sequence += 3;
    link.adc(1200);
    link.adc(1800);
    link.adc(3000);
    link.sequence += 3;
    link.say(Type::kError, toPayload(BoxError{Code::kOverrun, 3600, "slow"}));
    link.adc(4200);
    EXPECT_EQ(eventsOf<Gap>(link.events),
              (std::vector<Gap>{
                  {600, 600, GapReason::kLink}, {2400, 600, GapReason::kBox}, {3600, 600, GapReason::kBox}}));
}

TEST(Studio, StopsAForeignStreamBeforeStart) {
    Scripted link;
    link.open();
    link.hello(true);
    link.adc(1'000'000);
    EXPECT_EQ(countOf<AdcBlock>(link.events), 0u);
    link.studio.start(link.now_ns);
    link.collect();
    EXPECT_EQ(link.sent.back().first, Type::kStop);
    link.adc(1'000'600);
    link.ack(link.sent.back().second);
    EXPECT_EQ(link.sent.back().first, Type::kStart);
    link.adc(0);
    EXPECT_EQ(countOf<AdcBlock>(link.events), 1u);
    EXPECT_EQ(countOf<Gap>(link.events), 0u);
}

TEST(Studio, StopWaitsWhileTheBoxSendsWhatItHolds) {
    Scripted link;
    link.startTake();
    link.studio.stop(link.now_ns);
    link.collect();
    const uint32_t stop = link.sent.back().second;
    for (int i = 1; i < 8; ++i) {
        link.wait_ms(300);
        link.adc(600 * i);
    }
    EXPECT_EQ(link.sentOf(Type::kStop), 1u);
    link.ack(stop);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    EXPECT_EQ(countOf<AdcBlock>(link.events), 8u);
}

TEST(Studio, AnUnansweredStopEndsTheTakeAllTheSame) {
    Scripted link;
    link.startTake();
    link.studio.stop(link.now_ns);
    link.wait_ms(3000);
    EXPECT_EQ(link.sentOf(Type::kStop), 3u);
    EXPECT_EQ(countOf<RequestFailed>(link.events), 1u);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    EXPECT_FALSE(link.studio.takeIsOpen());
}

TEST(Studio, ImpossibleContentIsCountedAndLeftOut) {
    Scripted link;
    link.startTake();
    const auto bad = [&] { return link.studio.statistics().bad_content; };
    const size_t before = link.events.size();
    link.adc(600 + 61 * 150'000);
    link.say(Type::kAdc, toPayload(soundBlock(600, 10, 3)));
    link.say(Type::kAdc, Bytes(17));
    link.say(Type::kPulses, toPayload(Pulses{{61 * 150'000, 0}}));
    link.say(Type::kPulses, toPayload(Pulses{{1200, 1}}));
    link.say(Type::kPulses, Bytes(3));
    link.say(Type::kStatus, Scripted::status(61 * 150'000));
    link.say(Type::kStatus, toPayload(BoxStatus{}));
    link.say(Type::kError, toPayload(BoxError{Code::kBatteryLow, 61 * 150'000, "x"}));
    link.say(Type::kAck, Bytes(5));
    link.say(Type::kHello, bytesOf("[]"));
    EXPECT_EQ(bad(), 11);
    EXPECT_EQ(link.events.size(), before);
    link.say(static_cast<Type>(0x42), {});
    link.say(Type::kQuery, {});
    EXPECT_EQ(link.studio.statistics().unknown_types, 2);
    link.adc(600);
    EXPECT_EQ(countOf<Gap>(link.events), 0u);
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

TEST(Studio, GoldenDamage) {
    const Bytes stream = damagedStream();
    constexpr size_t kEndOfHello = 797;
    for (const size_t piece : {size_t{1}, size_t{7}, stream.size()}) {
        Scripted link;
        link.open();
        link.studio.receive(ByteView(stream).first(kEndOfHello), link.now_ns);
        link.studio.start(link.now_ns);
        for (size_t at = kEndOfHello; at < stream.size(); at += piece)
            link.studio.receive(ByteView(stream).subspan(at, std::min(piece, stream.size() - at)),
                                link.now_ns);
        link.collect();
        std::vector<std::pair<int64_t, int64_t>> blocks;
        for (const AdcBlock& block : eventsOf<AdcBlock>(link.events))
            blocks.emplace_back(block.first_sample, block.sampleCount());
        EXPECT_EQ(blocks,
                  (std::vector<std::pair<int64_t, int64_t>>{{0, 8}, {16, 8}, {32, 8}, {56, 8}, {64, 12}}));
        EXPECT_EQ(eventsOf<Gap>(link.events),
                  (std::vector<Gap>{
                      {8, 8, GapReason::kLink}, {24, 8, GapReason::kLink}, {40, 16, GapReason::kLink}}));
        const LinkStatistics counts = link.studio.statistics();
        EXPECT_EQ(counts.frames.damaged_payloads, 2);
        EXPECT_EQ(counts.frames.lost_frames, 2);
        EXPECT_EQ(counts.frames.unknown_versions, 1);
        EXPECT_EQ(counts.duplicate_blocks, 1);
        EXPECT_EQ(counts.unknown_types, 1);
        EXPECT_EQ(counts.bad_content, 1);
        EXPECT_EQ(counts.lost_samples, 32);
    }
}

}  // namespace
}  // namespace noctule::link
