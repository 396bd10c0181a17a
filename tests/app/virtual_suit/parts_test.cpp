// SPDX-License-Identifier: Apache-2.0
// The parts that need no program, socket or clock.
#include <gtest/gtest.h>

#include <bit>
#include <numeric>

#include "app/virtual_suit/board_wiring.h"
#include "app/virtual_suit/byte_faults.h"
#include "app/virtual_suit/control_command.h"
#include "app/virtual_suit/instruments.h"
#include "app/virtual_suit/options.h"
#include "app/virtual_suit/pacing.h"
#include "app/virtual_suit/sound_maker.h"
#include "core/suit/default_suit.h"

namespace noctule::virtual_suit {
namespace {

constexpr int64_t kPartSecond_ns = 1'000'000'000;

TEST(Pacer, SamplesAreDueWhenTheyAreOver) {
    for (const double speed : {0.5, 1.0, 20.0}) {
        Pacer pacer(150000, speed);
        pacer.start(7 * kPartSecond_ns);
        EXPECT_EQ(pacer.due(7 * kPartSecond_ns), 0);
        EXPECT_NEAR(static_cast<double>(pacer.due(9 * kPartSecond_ns)), 300000 * speed, 1);
        EXPECT_NEAR(static_cast<double>(pacer.due(7 * kPartSecond_ns + 4'000'000)), 600 * speed, 1);
    }
}

TEST(Pacer, ALittleIsCaughtUpAndALotIsNot) {
    Pacer pacer(150000, 2);
    constexpr int64_t kPatience_ns = kPartSecond_ns / 4;
    pacer.start(0);
    pacer.holdTo(270000, kPartSecond_ns, kPatience_ns);  // a tenth of a second behind
    EXPECT_EQ(pacer.lost_ns(), 0);
    EXPECT_NEAR(static_cast<double>(pacer.due(kPartSecond_ns)), 300000, 1);
    pacer.holdTo(0, kPartSecond_ns, kPatience_ns);
    EXPECT_NEAR(static_cast<double>(pacer.lost_ns()), 0.75e9, 10);
    EXPECT_NEAR(static_cast<double>(pacer.due(kPartSecond_ns)), 75000, 2);
    pacer.start(kPartSecond_ns);
    EXPECT_EQ(pacer.lost_ns(), 0);
}

TEST(ByteFaults, NothingHappensUnlessAsked) {
    link::Bytes bytes(10000);
    std::iota(bytes.begin(), bytes.end(), uint8_t{0});
    ByteFaults faults(1);
    EXPECT_EQ(faults.pass(bytes), bytes);
    faults.setDropRate(1);
    EXPECT_TRUE(faults.pass(bytes).empty());
    faults.setDropRate(0);
    faults.setFlipRate(1);
    const link::Bytes flipped = faults.pass(bytes);
    for (size_t i = 0; i < bytes.size(); ++i)
        ASSERT_EQ(flipped[i], static_cast<uint8_t>(~bytes[i]));
    faults.setFlipRate(0);
    EXPECT_EQ(faults.pass(bytes), bytes);
}

TEST(ByteFaults, RatesAreKept) {
    const link::Bytes zeros(1'000'000);
    ByteFaults faults(2);
    faults.setDropRate(0.01);
    EXPECT_NEAR(static_cast<double>(zeros.size() - faults.pass(zeros).size()), 10000, 500);  // 5 sigma
    faults.setDropRate(0);
    faults.setFlipRate(1e-3);
    double flips = 0;
    for (const uint8_t byte : faults.pass(zeros))
        flips += std::popcount(byte);
    EXPECT_NEAR(flips, 8000, 450);
}

TEST(ByteFaults, PiecesOfAnySizeGiveTheSame) {
    const link::Bytes bytes(5000, 0x55);
    for (const bool drop : {true, false}) {
        ByteFaults whole(3), pieces(3);
        for (ByteFaults* faults : {&whole, &pieces})
            drop ? faults->setDropRate(0.02) : faults->setFlipRate(0.02);
        link::Bytes joined;
        for (size_t at = 0; at < bytes.size(); at += 125) {
            const link::Bytes piece = pieces.pass(link::Bytes(125, 0x55));
            joined.insert(joined.end(), piece.begin(), piece.end());
        }
        EXPECT_EQ(joined, whole.pass(bytes));
        EXPECT_NE(joined, bytes);
    }
}

link::SoundBlock threeBoards(int64_t first_sample) {
    link::SoundBlock block{first_sample, 3, {}};
    for (int i = 0; i < 600; ++i)
        block.values.insert(block.values.end(), {100, 200, 300});
    return block;
}

TEST(BoardWiring, UnpluggedIsSilentAndSaysSo) {
    BoardWiring wiring(3, 150000, 1);
    EXPECT_FALSE(wiring.plug(1));
    EXPECT_TRUE(wiring.unplug(1));
    EXPECT_FALSE(wiring.unplug(1));
    link::SoundBlock block = threeBoards(0);
    wiring.apply(block);
    for (size_t i = 0; i < block.values.size(); i += 3) {
        ASSERT_EQ(block.values[i], 100);
        ASSERT_LE(std::abs(block.values[i + 1]), 1);
        ASSERT_EQ(block.values[i + 2], 300);
    }
    EXPECT_EQ(wiring.flags(0), link::kBoardConnected);
    EXPECT_EQ(wiring.flags(1), 0);
    EXPECT_TRUE(wiring.plug(1));
    block = threeBoards(600);
    wiring.apply(block);
    EXPECT_EQ(block, threeBoards(600));
}

TEST(BoardWiring, SwappedTwiceIsAsItWas) {
    BoardWiring wiring(3, 150000, 1);
    wiring.swap(0, 2);
    link::SoundBlock block = threeBoards(0);
    wiring.apply(block);
    EXPECT_EQ(block.values[0], 300);
    EXPECT_EQ(block.values[1], 200);
    EXPECT_EQ(block.values[2], 100);
    wiring.swap(0, 2);
    block = threeBoards(600);
    wiring.apply(block);
    EXPECT_EQ(block, threeBoards(600));
}

TEST(BoardWiring, ClippingIsToldForASecond) {
    BoardWiring wiring(3, 1200, 1);
    link::SoundBlock block = threeBoards(0);
    block.values[2] = -32767;
    wiring.apply(block);
    EXPECT_EQ(wiring.flags(1), link::kBoardConnected);
    EXPECT_EQ(wiring.flags(2), link::kBoardConnected | link::kBoardClipping);
    for (int64_t at = 600; at < 2400; at += 600) {
        block = threeBoards(at);
        wiring.apply(block);
    }
    EXPECT_EQ(wiring.flags(2), link::kBoardConnected);
}

TEST(Instruments, AccidentsReplaceWhatTheSourceMeasures) {
    Instruments instruments([](int64_t) { return Measurements{21.5, 40.0, {}, {}}; });
    link::BoxStatus status = instruments.read(0, 0);
    EXPECT_EQ(status.temperature_c, 21.5F);
    EXPECT_EQ(status.humidity_percent, 40.0F);
    EXPECT_FALSE(status.battery_percent);
    instruments.setTemperature(-3);
    instruments.setBattery(50, 0);
    status = instruments.read(0, 3600 * kPartSecond_ns);
    EXPECT_EQ(status.temperature_c, -3.0F);
    EXPECT_NEAR(*status.battery_percent, 50 - 12.5, 1e-4);
    EXPECT_GT(*status.battery_v, 3.3F);
    EXPECT_EQ(instruments.read(0, 90'000 * kPartSecond_ns).battery_percent, 0.0F);
}

TEST(ControlCommand, EveryCommandIsUnderstood) {
    const Suit suit = defaultSuit();
    const std::string id = suit.boards[3].id;
    const auto parsed = [&](const std::string& line) {
        const auto command = parseControlCommand(line, suit);
        EXPECT_TRUE(command) << line;
        return command ? *command : ControlCommand{};
    };
    EXPECT_EQ(parsed("unplug " + id).board, 3);
    EXPECT_EQ(parsed("unplug 4").board, 3);
    EXPECT_EQ(parsed(" plug  18 ").board, 17);
    EXPECT_EQ(parsed("swap 1 2").other_board, 1);
    EXPECT_EQ(parsed("slip 2 -12.5").number, -12.5);
    EXPECT_EQ(parsed("drop-bytes 1e-5").number, 1e-5);
    EXPECT_EQ(parsed("flip-bits 0").kind, ControlKind::kFlipBits);
    EXPECT_EQ(parsed("stall 2").kind, ControlKind::kStall);
    EXPECT_EQ(parsed("cut 0.5").kind, ControlKind::kCut);
    EXPECT_EQ(parsed("battery 100").number, 100);
    EXPECT_EQ(parsed("temperature -10").number, -10);
    EXPECT_EQ(parsed("quit").kind, ControlKind::kQuit);
    EXPECT_EQ(parsed("pose sit").pose, "sit");
    EXPECT_EQ(parsed("side -z").side, (simulation::RigSide{2, -1}));
    EXPECT_EQ(parsed("spin x -33.3").side, (simulation::RigSide{0, +1}));
    EXPECT_EQ(parsed("spin x -33.3").number, -33.3);
    EXPECT_EQ(parsed("placement 6").number, 6);
}

TEST(ControlCommand, MistakesAreNamedWithWhatIsRight) {
    const Suit suit = defaultSuit();
    const std::pair<const char*, const char*> mistakes[] = {
        {"", "empty"},
        {"unplg 1", "unplug"},
        {"unplug", "unplug BOARD"},
        {"unplug 19", "'19'"},
        {"unplug 0", "from 1"},
        {"unplug l_hnd", "l_hnd"},
        {"unplug 1.5", "1.5"},
        {"swap 1", "swap A B"},
        {"swap 2 2", "two boards"},
        {"stall x", "'x'"},
        {"stall -1", "'-1'"},
        {"drop-bytes 2", "from 0 to 1"},
        {"battery nan", "nan"},
        {"quit now", "quit"},
        {"pose lie", "sit"},
        {"side w", "'w'"},
        {"spin y", "spin SIDE RPM"},
        {"spin y 1000", "-200 to 200"},
        {"placement 0", "from 1"},
        {"placement 1.5", "whole"},
    };
    for (const auto& [line, named] : mistakes) {
        const auto command = parseControlCommand(line, suit);
        ASSERT_FALSE(command) << line;
        EXPECT_NE(command.error().text().find(named), std::string::npos) << command.error().text();
        EXPECT_EQ(command.error().text().find('\n'), std::string::npos);
    }
}

TEST(Address, WhatPeopleWrite) {
    EXPECT_EQ(toText(*parseAddress("localhost:7", "--tcp")), "127.0.0.1:7");
    EXPECT_EQ(toText(*parseAddress("[::1]:65535", "--tcp")), "[::1]:65535");
    EXPECT_EQ(toText(*parseAddress("0.0.0.0:0", "--tcp")), "0.0.0.0:0");
    for (const char* wrong : {"", ":", "127.0.0.1", "127.0.0.1:", "127.0.0.1:x", "1.2.3.4:65536", "nobody:1"})
        EXPECT_FALSE(parseAddress(wrong, "--tcp")) << wrong;
}

/// Counts; fails or ends where it is told.
class CountingSource : public SoundSource {
public:
    int64_t ends_at = INT64_MAX, fails_at = INT64_MAX;
    Status restart(int64_t /*begin_ns*/) override {
        next_sample_ = 0;
        return Done{};
    }
    Result<std::optional<SoundBlock>> next() override {
        if (next_sample_ >= fails_at)
            return Error{ErrorKind::kUnreadable, "the test's disk is broken", "Nothing"};
        if (next_sample_ >= ends_at)
            return std::optional<SoundBlock>();
        SoundBlock block{{next_sample_, 1, std::vector<int16_t>(600, 7)}, {}};
        next_sample_ += 600;
        return std::optional(block);
    }
    bool isSimulated() const override { return false; }
    Status accepts(const ControlCommand&) const override { return Done{}; }

private:
    int64_t next_sample_ = 0;
};

SoundBlock waitForBlock(SoundMaker& maker) {
    for (int i = 0; i < 2000; ++i) {
        if (auto block = maker.next(INT64_MAX))
            return *block;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "no sound";
    return {};
}

TEST(SoundMaker, GoesOnWithSilenceAndBeginsAgain) {
    auto source = std::make_unique<CountingSource>();
    source->ends_at = 1200;
    SoundMaker maker(std::move(source), 1, 3000);
    for (int round = 0; round < 2; ++round) {
        for (int64_t at = 0; at < 3000; at += 600) {
            EXPECT_EQ(maker.ended(), at > 1200);
            const SoundBlock block = waitForBlock(maker);
            EXPECT_EQ(block.adc.first_sample, at);
            EXPECT_EQ(block.adc.values, std::vector<int16_t>(600, at < 1200 ? 7 : 0));
        }
        maker.restart(0);
    }
    EXPECT_FALSE(maker.takeTrouble());
}

TEST(SoundMaker, NothingComesBeforeItIsDue) {
    SoundMaker maker(std::make_unique<CountingSource>(), 1, 3000);
    while (!maker.isReady())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(maker.next(599));
    EXPECT_TRUE(maker.next(600));
    EXPECT_FALSE(maker.next(1199));
}

TEST(SoundMaker, TroubleIsToldOnceAndSilenceFollows) {
    auto source = std::make_unique<CountingSource>();
    source->fails_at = 600;
    SoundMaker maker(std::move(source), 1, 3000);
    EXPECT_EQ(waitForBlock(maker).adc.values[0], 7);
    EXPECT_EQ(waitForBlock(maker).adc.values[0], 0);
    EXPECT_TRUE(maker.takeTrouble());
    EXPECT_FALSE(maker.takeTrouble());
}

}  // namespace
}  // namespace noctule::virtual_suit
