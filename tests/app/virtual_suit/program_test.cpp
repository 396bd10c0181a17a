// SPDX-License-Identifier: Apache-2.0
// The built program against the studio's side of the conversation.
#include "core/recording/take.h"
#include "tests/app/virtual_suit/test_studio.h"

namespace noctule::test {
namespace {

struct TinySound {
    std::vector<int16_t> values;
    std::vector<link::EmittedPulse> pulses;
    int64_t samples = 0;
};

TinySound tinySound() {
    const Take take = Take::open(kTinyTake).value();
    TinySound sound;
    EXPECT_TRUE(take.forEachBlock(1, [&](const AdcBlock& block) {
        sound.values.insert(sound.values.end(), block.values.begin(), block.values.end());
        return true;
    }));
    const std::vector<Pulse> pulses = take.pulses().value();
    for (const Pulse& pulse : pulses)
        sound.pulses.push_back({pulse.sample, pulse.source});
    sound.samples = *take.sampleCount();
    return sound;
}

TestStudio::Open tcp(const RunningSuit& suit) {
    return [port = suit.tcpPort()] { return connectTo(port); };
}

/// Every sample once and in order; those of the take are the take's, silence follows (or the take again).
void expectTinyTake(const TestStudio& studio, bool loop = false) {
    static const TinySound tiny = tinySound();
    int64_t next = 0;
    for (const link::StudioEvent& event : studio.events) {
        if (const auto* gap = std::get_if<link::Gap>(&event)) {
            ASSERT_EQ(gap->first_sample, next);
            next += gap->sample_count;
        }
        const auto* block = std::get_if<link::SoundBlock>(&event);
        if (!block)
            continue;
        ASSERT_EQ(block->first_sample, next);
        for (size_t i = 0; i < block->values.size(); ++i) {
            const int64_t sample = next + static_cast<int64_t>(i / 2);
            const int16_t wanted =
                loop || sample < tiny.samples ? tiny.values[(sample % tiny.samples) * 2 + i % 2] : 0;
            ASSERT_EQ(block->values[i], wanted) << sample;
        }
        next += block->sampleCount();
    }
    EXPECT_GT(next, 0);
    const std::vector<link::EmittedPulse> pulses = studio.pulses();
    for (size_t i = 0; i < pulses.size(); ++i) {
        const int64_t lap = loop ? pulses[i].sample / tiny.samples : 0;
        const link::EmittedPulse& wanted = tiny.pulses[i % tiny.pulses.size()];
        ASSERT_EQ(pulses[i], (link::EmittedPulse{lap * tiny.samples + wanted.sample, wanted.source})) << i;
    }
    for (const link::EmittedPulse& pulse : tiny.pulses)
        EXPECT_TRUE(pulse.sample >= next || std::find(pulses.begin(), pulses.end(), pulse) != pulses.end())
            << pulse.sample;
}

TEST(VirtualSuit, ATakeArrivesBitForBitOverTcp) {
    RunningSuit suit({"--take", kTinyTake, "--speed", "4"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 310'000; }));
    ASSERT_TRUE(studio.stop());
    EXPECT_EQ(studio.count<link::Gap>(), 0u);
    expectTinyTake(studio);
    const link::Hello hello = studio.all<link::Greeted>()[0].hello;
    EXPECT_EQ(hello.serial, "NB-000777");
    EXPECT_EQ(hello.boardCount(), 2);
    ASSERT_TRUE(studio.runUntil([&] { return studio.count<link::BoxStatus>() > 0; }));
    const link::BoxStatus status = studio.all<link::BoxStatus>()[0];
    EXPECT_NEAR(*status.temperature_c, 22.7, 0.1);
    EXPECT_EQ(status.battery_percent, 85.0F);
    EXPECT_EQ(status.board_flags, std::vector<uint16_t>(2, link::kBoardConnected));
}

TEST(VirtualSuit, ATakeArrivesBitForBitOverASerialLine) {
    RunningSuit suit({"--take", kTinyTake, "--speed", "3", "--pty", "--loop"});
    for (int round = 0; round < 2; ++round) {
        TestStudio studio([path = suit.terminal()] { return openTerminal(path); });
        ASSERT_TRUE(studio.start());
        ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 340'000; }));
        ASSERT_TRUE(studio.stop());
        EXPECT_EQ(studio.count<link::Gap>(), 0u);
        EXPECT_EQ(studio.conversation.statistics().frames.losses(), 0);
        expectTinyTake(studio, true);
    }
}

TEST(VirtualSuit, RunsInRealTimeAndEachStartFromTheBeginning) {
    RunningSuit suit({"--take", kTinyTake});
    TestStudio studio(tcp(suit));
    for (int round = 0; round < 2; ++round) {
        studio.events.clear();
        if (round > 0)
            studio.conversation.start(nowNs());
        ASSERT_TRUE(round > 0 || studio.start());
        const int64_t begun_ns = nowNs();
        ASSERT_TRUE(studio.runUntil([&] { return studio.samples() >= 150'000; }));
        EXPECT_GT(static_cast<double>(nowNs() - begun_ns), 0.85e9);
        ASSERT_TRUE(studio.stop());
        expectTinyTake(studio);
    }
}

TEST(VirtualSuit, BoardsCanBeUnpluggedAndSwapped) {
    RunningSuit suit({"--take", kTinyTake, "--loop"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    const auto isSilent = [&] {
        const auto blocks = studio.all<link::SoundBlock>();
        int loudest = 0;
        for (size_t i = 1; i < blocks.back().values.size(); i += 2)
            loudest = std::max<int>(loudest, std::abs(blocks.back().values[i]));
        return loudest <= 1;
    };
    const auto flags = [&] {
        const auto all = studio.all<link::BoxStatus>();
        return all.empty() ? 99 : int{all.back().board_flags[1]};
    };
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 60'000; }));
    EXPECT_FALSE(isSilent());
    EXPECT_EQ(suit.tell("unplug 2"), "ok");
    EXPECT_TRUE(suit.tell("unplug 2").starts_with("error "));
    EXPECT_TRUE(studio.runUntil([&] { return isSilent() && flags() == 0; }, 5));
    EXPECT_TRUE(studio.heard(link::Code::kBoardLost));
    EXPECT_EQ(suit.tell("plug 2"), "ok");
    EXPECT_TRUE(studio.runUntil([&] { return !isSilent() && flags() == link::kBoardConnected; }, 5));
    EXPECT_TRUE(studio.heard(link::Code::kBoardFound));
    EXPECT_EQ(suit.tell("swap 1 2"), "ok");
    studio.run(0.2);
    const auto block = studio.all<link::SoundBlock>().back();
    const TinySound tiny = tinySound();
    const int64_t at = block.first_sample % tiny.samples;
    EXPECT_EQ(block.values[0], tiny.values[at * 2 + 1]);
    EXPECT_EQ(block.values[1], tiny.values[at * 2]);
    EXPECT_TRUE(suit.tell("slip 1 20").starts_with("error ")) << "a take";
}

TEST(VirtualSuit, ACutLinkResumesWithoutShiftingTime) {
    RunningSuit suit({"--take", kTinyTake, "--loop"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 60'000; }));
    EXPECT_EQ(suit.tell("cut 1.5"), "ok");
    EXPECT_LT(connectTo(suit.tcpPort()), 0);
    ASSERT_TRUE(studio.runUntil([&] { return studio.count<link::Resumed>() == 1; }));
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 600'000; }));
    ASSERT_TRUE(studio.stop());
    EXPECT_EQ(studio.count<link::TakeEnded>(), 0u);
    expectTinyTake(studio, true);
}

TEST(VirtualSuit, BadCablesCostSamplesButNoTime) {
    RunningSuit suit({"--take", kTinyTake, "--loop"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    EXPECT_EQ(suit.tell("drop-bytes 0.0001"), "ok");
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 150'000; }));
    EXPECT_EQ(suit.tell("drop-bytes 0"), "ok");
    EXPECT_GT(studio.count<link::Gap>(), 0u);
    const int64_t lost = studio.conversation.statistics().frames.losses();
    EXPECT_EQ(suit.tell("flip-bits 0.00001"), "ok");
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 300'000; }));
    EXPECT_GT(studio.conversation.statistics().frames.losses(), lost);
    EXPECT_EQ(suit.tell("flip-bits 0"), "ok");
    studio.run(0.5);
    int64_t next = 0;
    for (const link::StudioEvent& event : studio.events) {
        if (const auto* gap = std::get_if<link::Gap>(&event))
            next = gap->first_sample + gap->sample_count;
        if (const auto* block = std::get_if<link::SoundBlock>(&event)) {
            EXPECT_EQ(block->first_sample, next);
            next = block->first_sample + block->sampleCount();
        }
    }
}

TEST(VirtualSuit, AStallFillsTheBuffersAndDropsTheOldest) {
    RunningSuit suit({"--take", kTinyTake, "--loop"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 60'000; }));
    EXPECT_EQ(suit.tell("stall 2.2"), "ok");
    ASSERT_TRUE(studio.runUntil([&] { return studio.count<link::Flowing>() == 1; }));
    ASSERT_TRUE(studio.runUntil([&] { return studio.heard(link::Code::kOverrun); }));
    studio.run(1.2);
    EXPECT_EQ(studio.count<link::Stalled>(), 1u);
    EXPECT_EQ(studio.count<link::LinkLost>(), 0u);
    const auto gaps = studio.all<link::Gap>();
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_NEAR(static_cast<double>(gaps[0].sample_count), 1.2 * 150'000, 0.4 * 150'000);
    EXPECT_EQ(studio.all<link::BoxStatus>().back().dropped_samples, gaps[0].sample_count);
    expectTinyTake(studio, true);
}

TEST(VirtualSuit, AHoleInATakeTakesItsTime) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, "DELETE FROM adc_block WHERE first_sample BETWEEN 60000 AND 209999");
    runSql(path, "UPDATE meta SET value='8' WHERE key='source_count'");
    runSql(path, "UPDATE pulse SET source=7 WHERE id=(SELECT min(id) FROM pulse)");
    RunningSuit suit({"--take", path});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    const int64_t begun_ns = nowNs();
    ASSERT_TRUE(studio.runUntil([&] { return studio.samples() >= 300'000; }, 8)) << studio.samples();
    EXPECT_NEAR(static_cast<double>(nowNs() - begun_ns) * 1e-9, 2, 0.5);
    const auto gaps = studio.all<link::Gap>();
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_GE(gaps[0].sample_count, 140'000);
    for (const link::EmittedPulse& pulse : studio.pulses())
        EXPECT_LT(pulse.source, 2) << "the suit has two sources";
}

TEST(VirtualSuit, AClientThatDoesNotReadNeverStallsTheSampling) {
    RunningSuit suit({"--rig", "rest", "--scenario", "ideal"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    const int64_t before = studio.samples(), since_ns = nowNs();
    studio.reads = false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    studio.reads = true;
    ASSERT_TRUE(studio.runUntil([&] { return studio.heard(link::Code::kOverrun); }));
    studio.run(1.0);
    const double wanted = static_cast<double>(before) + static_cast<double>(nowNs() - since_ns) * 1.5e-4;
    EXPECT_NEAR(static_cast<double>(studio.samples()), wanted, 0.4 * 150'000);
    EXPECT_GT(studio.count<link::Gap>(), 0u);
}

TEST(VirtualSuit, OnlyOneStudioAtATime) {
    RunningSuit suit({"--take", kTinyTake, "--pty"});
    TestStudio first(tcp(suit));
    ASSERT_TRUE(first.greet());
    const int second = connectTo(suit.tcpPort());
    bool closed = false;
    EXPECT_EQ(readSome(second, 2000, &closed), "");
    EXPECT_TRUE(closed);
    close(second);
    ASSERT_TRUE(first.start());
    first.hangUp();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    TestStudio next([path = suit.terminal()] { return openTerminal(path); });
    ASSERT_TRUE(next.start()) << "the first studio's take is cleared away";
    expectTinyTake(next);
}

TEST(VirtualSuit, InstrumentsAndBattery) {
    RunningSuit suit({"--take", kTinyTake});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.greet());
    EXPECT_EQ(suit.tell("temperature 31.5"), "ok");
    EXPECT_EQ(suit.tell("battery 8"), "ok");
    const auto last = [&] {
        const auto all = studio.all<link::BoxStatus>();
        return all.empty() ? link::BoxStatus{} : all.back();
    };
    ASSERT_TRUE(studio.runUntil([&] { return last().temperature_c == 31.5F; }, 5));
    EXPECT_NEAR(*last().battery_percent, 8, 0.1);
    EXPECT_EQ(last().board_flags[0], link::kBoardConnected | link::kBoardLowSupply);
    EXPECT_EQ(suit.tell("battery 4"), "ok");
    ASSERT_TRUE(studio.runUntil([&] { return studio.heard(link::Code::kBatteryLow); }, 5));
    EXPECT_EQ(suit.tell("battery 0"), "ok");
    ASSERT_TRUE(studio.runUntil([&] { return studio.count<link::LinkLost>() == 1; }, 5));
    EXPECT_TRUE(studio.heard(link::Code::kShuttingDown));
    EXPECT_EQ(suit.tell("battery 90"), "ok");
    EXPECT_TRUE(studio.runUntil([&] { return studio.count<link::Greeted>() == 2; }));
}

TEST(VirtualSuit, AnnouncesItself) {
    RunningSuit suit({"--take", kTinyTake, "--announce", "--announce-port", "0"});
    const int descriptor = connectTo(suit.announcePort(), SOCK_DGRAM);
    const std::string question = "NOCTULE-DISCOVER";
    ASSERT_EQ(send(descriptor, "NOCTULE-DISCOVERY", 17, 0), 17);
    EXPECT_EQ(readSome(descriptor, 200), "");
    ASSERT_EQ(send(descriptor, question.data(), question.size(), 0), 16);
    const std::string answer = readSome(descriptor, 3000);
    close(descriptor);
    link::FrameReader reader;
    std::optional<link::Announcement> announcement;
    reader.push({reinterpret_cast<const uint8_t*>(answer.data()), answer.size()}, 0,
                [&](const link::LinkFrame& frame) {
                    EXPECT_EQ(frame.header.type, 0x08);
                    announcement = link::readAnnouncement(frame.payload, "test").value();
                });
    ASSERT_TRUE(announcement);
    EXPECT_EQ(announcement->serial, "NB-000777");
    EXPECT_EQ(announcement->tcp_port, suit.tcpPort());
    EXPECT_EQ(announcement->boards, 2);
    EXPECT_FALSE(announcement->busy);
}

TEST(VirtualSuit, ASimulatedBoardSlips) {
    RunningSuit suit({"--rig", "rest", "--scenario", "ideal", "--seed", "5"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.start());
    EXPECT_EQ(studio.all<link::Greeted>()[0].hello.serial, "NB-900005");
    EXPECT_EQ(suit.tell("slip l_forearm 25"), "ok");
    EXPECT_EQ(suit.tell("spin y 45").substr(0, 6), "error ");
    EXPECT_EQ(suit.tell("jump").substr(0, 6), "error ");
    ASSERT_TRUE(studio.stop());
    EXPECT_EQ(studio.conversation.statistics().frames.losses(), 0);
}

/// As the guide has it, without a suit's file.
TEST(VirtualSuit, WhatIsInABagHasMagnetometers) {
    for (const char* rig : {"bag", "level"}) {
        RunningSuit suit({"--rig", rig, "--scenario", "ideal"});
        TestStudio studio(tcp(suit));
        ASSERT_TRUE(studio.greet());
        const link::Hello hello = studio.all<link::Greeted>().at(0).hello;
        for (const Board& board : hello.suit.boards)
            EXPECT_EQ(board.has_magnetometer, rig == std::string("bag")) << board.id;
        if (rig == std::string("bag"))
            for (const char* command : {"height 1.5", "height 0.15", "roll 240"})
                EXPECT_EQ(suit.tell(command), "ok") << command;
    }
}

TEST(VirtualSuit, RigsObeyTheirCommandsAndNoOthers) {
    const struct {
        const char* rig;
        std::vector<std::string> obeyed, refused;
    } rigs[] = {
        {"level", {"side +x", "side -z"}, {"spin y 45", "placement 2", "pose t", "slip 1 5"}},
        {"turntable", {"spin x 45", "spin -x 33.3", "spin x 0"}, {"side +x", "placement 2", "pose t"}},
        {"jig", {"placement 6", "placement 1"}, {"placement 7", "side +x", "spin y 45"}},
        {"rest", {"pose sit", "pose t", "pose rest"}, {"side +x", "spin y 45", "placement 1"}},
    };
    for (const auto& rig : rigs) {
        RunningSuit suit({"--rig", rig.rig, "--scenario", "ideal"});
        TestStudio studio(tcp(suit));
        ASSERT_TRUE(studio.start());
        for (const std::string& command : rig.obeyed)
            EXPECT_EQ(suit.tell(command), "ok") << rig.rig;
        for (const std::string& command : rig.refused)
            EXPECT_TRUE(suit.tell(command).starts_with("error ")) << rig.rig << ": " << command;
        ASSERT_TRUE(studio.runUntil([&] { return studio.samples() > 150'000; })) << rig.rig;
        EXPECT_EQ(studio.conversation.statistics().frames.losses(), 0);
    }
}

TEST(VirtualSuit, OnlyEnabledSourcesPulse) {
    RunningSuit suit({"--rig", "jig", "--scenario", "ideal"});
    TestStudio studio(tcp(suit));
    ASSERT_TRUE(studio.greet());
    link::Settings settings;
    settings.enabled_sources = {{6, 1}};
    studio.conversation.set(settings, nowNs());
    ASSERT_TRUE(studio.start());
    ASSERT_TRUE(studio.runUntil([&] { return studio.pulses().size() > 20; }));
    const auto pulses = studio.pulses();
    for (size_t i = 0; i < pulses.size(); ++i)
        EXPECT_EQ(pulses[i], (link::EmittedPulse{static_cast<int64_t>(i) * 1200, i % 2 == 0 ? 6 : 1}));
}

TEST(VirtualSuit, EndsOnCtrlCAndOnQuit) {
    for (const bool quit : {true, false}) {
        RunningSuit suit({"--take", kTinyTake});
        TestStudio studio(tcp(suit));
        ASSERT_TRUE(studio.start());
        EXPECT_EQ(quit ? suit.tell("quit") : "ok", "ok");
        const Ran ran = quit ? suit.wait() : suit.end(SIGINT);
        EXPECT_EQ(ran.exit_code, quit ? 0 : 130) << ran.err;
        ASSERT_TRUE(studio.runUntil([&] { return studio.count<link::LinkLost>() == 1; }, 5));
        EXPECT_TRUE(studio.heard(link::Code::kShuttingDown));
    }
}

TEST(VirtualSuitUsage, MistakesAreNamed) {
    Folder folder;
    writeBytes(folder.file("no.noctule"), "no take");
    const std::string readings = tinyTake(folder);
    runSql(readings, "INSERT INTO meta VALUES('level','readings')");
    struct Mistake {
        std::vector<std::string> arguments;
        int exit_code;
        std::string named;
    };
    const Mistake mistakes[] = {
        {{}, 2, "--take"},
        {{"--rig", "jib"}, 2, "jig"},
        {{"--rig", "jig", "--actor", "x"}, 2, "--actor"},
        {{"--rig", "rest", "--take", "x"}, 2, "--take"},
        {{"--take", "x", "--scenario", "ideal"}, 2, "--scenario"},
        {{"--take", "x", "--start-at", "noon"}, 2, "noon"},
        {{"--rig", "rest", "--start-at", "now"}, 2, "--take"},
        {{"--rig", "rest", "--tcp", "41941"}, 2, "41941"},
        {{"--rig", "rest", "--speed", "0"}, 2, "--speed"},
        {{"--rig", "rest", "--pty", "--announce"}, 2, "--tcp"},
        {{"walk.bvh"}, 2, "--motion walk.bvh"},
        {{"--take", folder.file("none.noctule")}, 3, "none.noctule"},
        {{"--take", folder.file("no.noctule")}, 3, "no.noctule"},
        {{"--motion", folder.file("none.bvh")}, 3, "none.bvh"},
        {{"--take", readings}, 4, "no sound"},
    };
    for (const Mistake& mistake : mistakes) {
        const Ran ran = run(mistake.arguments);
        EXPECT_EQ(ran.exit_code, mistake.exit_code) << ran.err;
        EXPECT_NE(ran.err.find(mistake.named), std::string::npos) << ran.err;
        EXPECT_TRUE(ran.out.empty()) << ran.out;
    }
    EXPECT_EQ(run({"--help"}).exit_code, 0);
    const RunningSuit suit({"--take", kTinyTake});
    const Ran second = run({"--take", kTinyTake, "--tcp", "127.0.0.1:" + std::to_string(suit.tcpPort())});
    EXPECT_EQ(second.exit_code, 5) << second.err;
    EXPECT_NE(second.err.find(std::to_string(suit.tcpPort())), std::string::npos) << second.err;
}

}  // namespace
}  // namespace noctule::test
