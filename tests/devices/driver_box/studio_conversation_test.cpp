// SPDX-License-Identifier: Apache-2.0
// The studio's side against bytes written by hand, to the millisecond.
#include "devices/driver_box/studio_conversation.h"

#include "devices/driver_box/crc32.h"
#include "tests/devices/driver_box/scripted_box.h"

namespace noctule::link {
namespace {

using State = StudioConversation::State;

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
    EXPECT_EQ(countOf<SoundBlock>(link.events), 1u);
    link.wait_ms(400);
    EXPECT_EQ(link.sentOf(Type::kStart), 1u);
    EXPECT_EQ(link.studio.state(), State::kStreaming);
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
    EXPECT_EQ(countOf<SoundBlock>(link.events), 0u);
    link.studio.start(link.now_ns);
    link.collect();
    EXPECT_EQ(link.sent.back().first, Type::kStop);
    link.adc(1'000'600);
    link.ack(link.sent.back().second);
    EXPECT_EQ(link.sent.back().first, Type::kStart);
    link.adc(0);
    EXPECT_EQ(countOf<SoundBlock>(link.events), 1u);
    EXPECT_EQ(countOf<Gap>(link.events), 0u);
}

/// A box that streams for nobody, START wished and STOP sent; gives STOP's sequence number.
uint32_t clearForStart(Scripted& link) {
    link.open();
    link.hello(true);
    link.studio.start(link.now_ns);
    link.collect();
    EXPECT_EQ(link.studio.state(), State::kClearing);
    return link.sent.back().second;
}

TEST(Studio, AStopBeforeTheForeignStreamHasEndedStartsNothing) {
    Scripted link;
    const uint32_t clearing = clearForStart(link);
    link.studio.stop(link.now_ns);
    link.adc(1'000'600);
    EXPECT_EQ(countOf<Stopped>(link.events), 0u);
    link.ack(clearing);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    EXPECT_EQ(link.sentOf(Type::kStart), 0u);
    EXPECT_EQ(link.sentOf(Type::kStop), 1u);
    EXPECT_EQ(countOf<SoundBlock>(link.events), 0u);
    EXPECT_EQ(link.studio.state(), State::kIdle);
    link.studio.start(link.now_ns);
    link.collect();
    EXPECT_EQ(link.sent.back().first, Type::kStart) << "the next start is free";
}

TEST(Studio, AStopOfAForeignStreamThatIsNeverAnsweredEndsTheWish) {
    Scripted link;
    clearForStart(link);
    link.studio.stop(link.now_ns);
    link.waitWithStatus_ms(3000);
    ASSERT_EQ(countOf<RequestFailed>(link.events), 1u);
    EXPECT_EQ(eventsOf<RequestFailed>(link.events)[0].type, Type::kStop);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    EXPECT_EQ(link.sentOf(Type::kStart), 0u);
    EXPECT_EQ(link.studio.state(), State::kIdle);
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
    EXPECT_EQ(countOf<SoundBlock>(link.events), 8u);
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
        for (const SoundBlock& block : eventsOf<SoundBlock>(link.events))
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
