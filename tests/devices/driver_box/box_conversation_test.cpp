// SPDX-License-Identifier: Apache-2.0
// The box's side against requests written by hand.
#include "devices/driver_box/box_conversation.h"

#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {
namespace {

constexpr size_t kAll = 100'000'000;

struct Client {
    explicit Client(BoxOptions options = {}) : box(testHello(), options) { box.connected(now_ns); }

    BoxConversation box;
    FrameReader reader;
    struct Got {
        Type type;
        uint32_t sequence;
        Bytes payload;
    };
    std::vector<Got> got;
    int64_t now_ns = kSecond_ns;
    uint32_t sequence = 0;

    uint32_t say(Type type, const Bytes& payload = {}) {
        box.receive(encodeFrame(static_cast<uint8_t>(type), sequence, payload), now_ns);
        return sequence++;
    }
    void read(size_t most = kAll) {
        const Bytes bytes = box.read(most);
        EXPECT_LE(bytes.size(), most);
        reader.push(bytes, 0, [&](const LinkFrame& frame) {
            got.push_back({static_cast<Type>(frame.header.type),
                           frame.header.sequence,
                           {frame.payload.begin(), frame.payload.end()}});
        });
    }
    void reconnect() {
        box.connected(now_ns);
        reader.restart();
        sequence = 0;
        got.clear();
    }
    /// Blocks of 600 samples.
    void offer(int64_t blocks) {
        for (; blocks > 0; --blocks)
            box.offer(soundBlock(box.nextSample(), 600, 2));
    }
    std::vector<Type> types() const {
        std::vector<Type> types;
        for (const Got& one : got)
            types.push_back(one.type);
        return types;
    }
    std::vector<int64_t> firstSamples() const {
        std::vector<int64_t> samples;
        for (const Got& one : got)
            if (one.type == Type::kAdc)
                samples.push_back(readSoundBlock(one.payload)->first_sample);
        return samples;
    }
    Code answer(Type type, const Bytes& payload) {
        const uint32_t request = say(type, payload);
        got.clear();
        read();
        EXPECT_EQ(got.size(), 1u);
        const auto ack = got.empty() ? std::nullopt : readAck(got[0].payload);
        EXPECT_TRUE(ack && got[0].type == Type::kAck && ack->request == request);
        return ack ? ack->code : Code::kOk;
    }
};

TEST(Box, AnswersQueryAndPing) {
    Client client;
    client.say(Type::kQuery);
    client.say(Type::kPing, bytesOf("ping-42"));
    client.read();
    ASSERT_EQ(client.types(), (std::vector<Type>{Type::kHello, Type::kPong}));
    EXPECT_EQ(readHello(client.got[0].payload, "box")->serial, "NB-000777");
    EXPECT_EQ(client.got[1].payload, bytesOf("ping-42"));
    EXPECT_EQ(client.got[1].sequence, 1u);
    EXPECT_EQ(client.reader.statistics().lost_frames, 0);
}

TEST(Box, AnswersEveryRequestWithACode) {
    Client client;
    EXPECT_EQ(client.answer(Type::kStop, {}), Code::kOk);
    EXPECT_EQ(client.answer(Type::kStop, Bytes(1)), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kQuery, Bytes(1)), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kPing, Bytes(65)), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kIdentify, toPayload(Identify{1, 1500})), Code::kOk);
    EXPECT_EQ(client.answer(Type::kIdentify, toPayload(Identify{kAllBoardsOff, 0})), Code::kOk);
    EXPECT_EQ(client.answer(Type::kIdentify, toPayload(Identify{2, 1500})), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kIdentify, Bytes(3)), Code::kBadPayload);
    EXPECT_EQ(client.answer(static_cast<Type>(0x99), {}), Code::kUnknownType);
    EXPECT_EQ(client.answer(Type::kHello, bytesOf("{}")), Code::kUnknownType);
    EXPECT_EQ(client.answer(Type::kSet, bytesOf("{")), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kSet, bytesOf(R"({"enabled_sources":[1]})")), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kSet, bytesOf(R"({"enabled_sources":[0],"pulse_cycles":8,"name":"x"})")),
              Code::kOk);
    EXPECT_EQ(client.box.hello().pulse_cycles, 8);
    EXPECT_EQ(client.box.hello().name, "x");
    EXPECT_EQ(client.answer(Type::kStart, Bytes(7)), Code::kBadPayload);
    EXPECT_EQ(client.answer(Type::kStart, startPayload()), Code::kOk);
    EXPECT_EQ(client.answer(Type::kStart, startPayload()), Code::kOk);
    EXPECT_EQ(client.answer(Type::kSet, bytesOf(R"({"name":"y"})")), Code::kNotNow);
    EXPECT_EQ(client.box.hello().name, "x");
    const std::vector<BoxEvent> events = client.box.takeEvents();
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(std::get<IdentifyWanted>(events[0]).identify, (Identify{1, 1500}));
    EXPECT_EQ(std::get<SettingsWanted>(events[2]).settings.enabled_sources, std::vector<int>{0});
    EXPECT_TRUE(std::holds_alternative<StartWanted>(events[3]));
}

TEST(Box, StartAgainChangesNothingAndStopSendsWhatItHolds) {
    Client client;
    client.say(Type::kStart, startPayload());
    client.offer(3);
    client.say(Type::kStart, startPayload());
    EXPECT_EQ(client.box.nextSample(), 1800);
    const uint32_t stop = client.say(Type::kStop);
    const uint32_t again = client.say(Type::kStop);
    EXPECT_FALSE(client.box.streaming());
    client.offer(1);  // after the end: not taken
    const uint32_t early = client.say(Type::kStart, startPayload());
    client.read();
    EXPECT_EQ(client.types(), (std::vector<Type>{Type::kAck, Type::kAck, Type::kAck, Type::kAdc, Type::kAdc,
                                                 Type::kAdc, Type::kAck, Type::kAck}));
    EXPECT_EQ(readAck(client.got[2].payload)->request, early);
    EXPECT_EQ(readAck(client.got[2].payload)->code, Code::kNotNow);
    EXPECT_EQ(readAck(client.got[6].payload)->request, stop);
    EXPECT_EQ(readAck(client.got[7].payload)->request, again);
    EXPECT_EQ(client.answer(Type::kStart, startPayload()), Code::kOk);
    EXPECT_EQ(client.box.nextSample(), 0);
}

TEST(Box, StatusComesEverySecondAndTellsTheNextSample) {
    Client client;
    BoxStatus conditions;
    conditions.battery_percent = 80.f;
    conditions.board_flags = {1, 3};
    client.box.setConditions(conditions);
    for (int i = 0; i < 30; ++i) {
        client.now_ns += kSecond_ns / 10;
        client.box.tick(client.now_ns);
        client.say(Type::kPing);
    }
    client.say(Type::kStart, startPayload());
    client.offer(2);
    client.now_ns += kSecond_ns;
    client.box.tick(client.now_ns);
    client.offer(1);
    client.read();
    std::vector<BoxStatus> all;
    for (const auto& one : client.got)
        if (one.type == Type::kStatus)
            all.push_back(*readStatus(one.payload));
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[3].sample, 0);  // written before the sound that was held
    EXPECT_EQ(all[3].battery_percent, 80.f);
    EXPECT_EQ(all[3].board_flags, (std::vector<uint16_t>{1, 3}));
    client.now_ns += kSecond_ns;
    client.box.tick(client.now_ns);
    client.got.clear();
    client.read();
    EXPECT_EQ(readStatus(client.got.at(0).payload)->sample, 1800);
}

TEST(Box, DropsTheOldestSoundOnlyAndSaysSo) {
    Client client({AdcFormat::kZstd, 0.25, true});
    client.say(Type::kStart, startPayload());
    client.offer(2);
    client.read(30 + 40);  // ACK; the first block has begun
    client.box.offer(std::vector<EmittedPulse>{{1200, 0}});
    client.offer(100);
    client.box.report({Code::kBatteryLow, 1200, "low"});
    client.now_ns += kSecond_ns;
    client.box.tick(client.now_ns);
    client.read();
    // 250 ms are 62.5 blocks: of blocks 1 to 101 the last 63 are kept.
    std::vector<int64_t> expected = {0};
    for (int64_t block = 101 - 62; block <= 101; ++block)
        expected.push_back(block * 600);
    EXPECT_EQ(client.firstSamples(), expected);
    EXPECT_EQ(client.types()[0], Type::kAck);
    EXPECT_EQ(client.types()[1], Type::kAdc);
    EXPECT_EQ(readError(client.got[2].payload),
              (BoxError{Code::kOverrun, 600, "the link is too slow, sound was dropped"}));
    EXPECT_EQ(readError(client.got[3].payload)->code, Code::kBatteryLow);
    EXPECT_EQ(readStatus(client.got[4].payload)->dropped_samples, 38u * 600);
    EXPECT_EQ(readStatus(client.got[4].payload)->sample, 39 * 600);
    EXPECT_EQ(client.types()[5], Type::kPulses);
    EXPECT_EQ(client.reader.statistics().lost_frames, 0);
}

TEST(Box, OnlyAPartOfAFrameCanBeWritten) {
    Client client;
    client.say(Type::kStart, startPayload());
    client.offer(5);
    for (int i = 0; i < 20'000; ++i)
        client.read(1);
    EXPECT_EQ(client.firstSamples(), (std::vector<int64_t>{0, 600, 1200, 1800, 2400}));
    EXPECT_EQ(client.reader.statistics().lost_frames, 0);
    EXPECT_EQ(client.reader.statistics().skipped_bytes, 0);
}

TEST(Box, GoesOnWithoutAClientAndThenWithTheNext) {
    Client client;
    client.say(Type::kStart, startPayload());
    client.offer(2);
    client.box.offer(std::vector<EmittedPulse>{{1200, 0}});
    client.read(3000);
    client.say(Type::kPing);
    client.box.disconnected(client.now_ns);
    client.offer(2);
    EXPECT_TRUE(client.box.read(kAll).empty());
    client.reconnect();
    client.read();
    EXPECT_TRUE(client.got.empty());  // nothing before HELLO
    client.say(Type::kQuery);
    client.read();
    ASSERT_FALSE(client.got.empty());
    EXPECT_EQ(client.got[0].type, Type::kHello);
    EXPECT_EQ(client.got[0].sequence, 0u);
    EXPECT_TRUE(readHello(client.got[0].payload, "box")->streaming);
    // ACK, pulses and the first block were out; the second had begun and comes again whole.
    EXPECT_EQ(client.firstSamples(), (std::vector<int64_t>{600, 1200, 1800}));
    for (const Type type : client.types())
        EXPECT_NE(type, Type::kPong);
    // A stranger's START must not continue this stream as if it began.
    EXPECT_EQ(client.answer(Type::kStart, startPayload()), Code::kNotNow);
}

TEST(Box, AClientThatGoesWhileStoppingLeavesNothingBehind) {
    Client client;
    client.say(Type::kStart, startPayload());
    client.offer(3);
    client.say(Type::kStop);
    client.reconnect();
    client.say(Type::kQuery);
    client.say(Type::kStop);
    client.read();
    EXPECT_EQ(client.types(), (std::vector<Type>{Type::kHello, Type::kAck}));
    EXPECT_FALSE(readHello(client.got[0].payload, "box")->streaming);
}

TEST(Box, StopsAfterTwoMinutesAlone) {
    Client client;
    client.say(Type::kStart, startPayload());
    client.box.disconnected(client.now_ns);
    client.box.tick(client.now_ns + 120 * kSecond_ns - 1);
    EXPECT_TRUE(client.box.streaming());
    client.box.tick(client.now_ns + 120 * kSecond_ns);
    EXPECT_FALSE(client.box.streaming());
    EXPECT_TRUE(std::holds_alternative<StopWanted>(client.box.takeEvents().back()));
    client.reconnect();
    client.say(Type::kQuery);
    client.read();
    EXPECT_FALSE(readHello(client.got.at(0).payload, "box")->streaming);
}

TEST(Box, DropsASilentTcpClientAndOneThatReadsNothing) {
    Client silent;
    silent.box.tick(silent.now_ns + 10 * kSecond_ns - 1);
    EXPECT_TRUE(silent.box.hasClient());
    silent.box.tick(silent.now_ns + 10 * kSecond_ns);
    EXPECT_FALSE(silent.box.hasClient());
    EXPECT_TRUE(std::holds_alternative<ClientDropped>(silent.box.takeEvents().back()));

    Client serial({AdcFormat::kPlain, 1, false});
    serial.box.tick(serial.now_ns + 100 * kSecond_ns);
    EXPECT_TRUE(serial.box.hasClient());

    Client deaf;
    for (int i = 0; i < 60'000; ++i)
        deaf.say(Type::kPing, Bytes(64));
    deaf.box.tick(deaf.now_ns);
    EXPECT_FALSE(deaf.box.hasClient());
}

TEST(Box, RandomBytesNeverBreakIt) {
    const std::vector<GoldenFrame> frames = goldenFrames();
    std::mt19937 random(3);
    Client client;
    for (int i = 0; i < 20'000; ++i) {
        Bytes bytes = frames[random() % frames.size()].bytes;
        if (i % 3 == 0)
            bytes[random() % bytes.size()] ^= static_cast<uint8_t>(1 << (random() % 8));
        if (i % 7 == 0)
            bytes = randomBytes(random, random() % 60);
        client.box.receive(bytes, client.now_ns += kMillisecond_ns);
        client.box.tick(client.now_ns);
        client.offer(1);
        client.box.read(random() % 5000);
        client.box.takeEvents();
        if (!client.box.hasClient())
            client.reconnect();
    }
    EXPECT_GT(client.box.statistics().frames, 5000);
}

TEST(BoxConversation, ABoxWhosePulsesAreFixedSaysSo) {
    BoxOptions options;
    options.sets_pulses = options.sets_sources = false;
    Client client(options);
    for (const char* wish :
         {R"({"pulse_interval_samples":900})", R"({"pulse_cycles":8})", R"({"enabled_sources":[0]})"})
        EXPECT_EQ(client.answer(Type::kSet, bytesOf(wish)), Code::kNotSupported) << wish;
    EXPECT_EQ(client.answer(Type::kSet, bytesOf(R"({"name":"x"})")), Code::kOk);
    EXPECT_EQ(client.box.hello().pulse_interval_samples, testHello().pulse_interval_samples);
}

}  // namespace
}  // namespace noctule::link
