// SPDX-License-Identifier: Apache-2.0
// A take that is made to be played again and again goes on where it says, with whole periods of the streams.
#include "app/virtual_suit/take_source.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/body/actor.h"
#include "core/recording/take_writer.h"
#include "core/suit/default_suit.h"
#include "tests/support/files.h"

namespace noctule::virtual_suit {
namespace {

constexpr int kLoopRate_hz = 7000, kBlock = 3500;

/// Each sample is its own number, thousands left out; a pulse every half second.
std::string numberedTake(const test::Folder& folder, int seconds, const std::string& loops_from) {
    const std::string path = folder.file("loop_" + std::to_string(seconds) + loops_from + ".noctule");
    Suit suit{"one", {}, {}};
    suit.boards.resize(1);
    suit.boards[0].id = "chest";
    suit.boards[0].segment = "Chest";
    suit.sources = {{"hat", "", "Head", {0, 0.2, 0}, {0, 1, 0}}};
    TakeHeader header;
    header.name = "loop";
    header.uuid = "0";
    header.created_utc = "2026-01-01T00:00:00Z";
    header.sample_rate_hz = kLoopRate_hz;
    header.board_count = header.source_count = 1;
    auto take = TakeWriter::create(path, header);
    EXPECT_TRUE(take);
    EXPECT_TRUE(take->addSuit(suit));
    if (!loops_from.empty()) {
        EXPECT_TRUE(take->setMeta(kLoopsFromKey, loops_from));
    }
    for (int64_t first = 0; first < int64_t{seconds} * kLoopRate_hz; first += kBlock) {
        std::vector<int16_t> values(kBlock);
        for (int i = 0; i < kBlock; ++i)
            values[static_cast<size_t>(i)] = static_cast<int16_t>((first + i) % 1000);
        EXPECT_TRUE(take->addBlock({first, values}, 1, 1));
        EXPECT_TRUE(take->addPulse(first, 0));
    }
    EXPECT_TRUE(take->finish());
    return path;
}

/// Two suits, the second of which begins a second later and is cut `shorter_s` before the first one's end.
/// `second_rate`: of its clock.
std::string takeOfTwo(const test::Folder& folder, int seconds, double shorter_s, double second_rate = 1) {
    const std::string path = folder.file("two.noctule");
    Suit suit{"one", {}, {}};
    suit.boards.resize(1);
    suit.boards[0].id = "chest";
    suit.boards[0].segment = "Chest";
    TakeHeader header;
    header.name = "two";
    header.uuid = "0";
    header.created_utc = "2026-01-01T00:00:00Z";
    header.sample_rate_hz = kLoopRate_hz;
    header.board_count = 1;
    auto take = TakeWriter::create(path, header);
    EXPECT_TRUE(take);
    EXPECT_TRUE(take->setMeta("subjects", R"([{"name":"A","suits":[1]},{"name":"B","suits":[2]}])"));
    for (const int number : {1, 2}) {
        const double begin_s = number - 1;
        EXPECT_TRUE(take->addSuit(suit, {1e9 * begin_s, number == 2 ? second_rate : 1}));
        EXPECT_TRUE(take->addActor(defaultActor(), "", number));
        const auto count =
            static_cast<int>((seconds - begin_s - (number == 2 ? shorter_s : 0)) * kLoopRate_hz);
        std::vector<int16_t> values(static_cast<size_t>(count));
        for (int i = 0; i < count; ++i)  // the tenth of a second of the take
            values[static_cast<size_t>(i)] = static_cast<int16_t>(10 * begin_s + i / (kLoopRate_hz / 10));
        EXPECT_TRUE(take->addBlock({0, values}, 1, number));
    }
    EXPECT_TRUE(take->finish());
    return path;
}

/// The next `count` samples, without a hole.
std::vector<int16_t> heardOf(SoundSource& source, size_t count) {
    std::vector<int16_t> heard;
    while (heard.size() < count) {
        const auto block = source.next();
        if (!block || !*block)
            break;
        EXPECT_EQ((*block)->adc.first_sample, static_cast<int64_t>(heard.size()));
        heard.insert(heard.end(), (*block)->adc.values.begin(), (*block)->adc.values.end());
    }
    heard.resize(std::min(heard.size(), count));
    return heard;
}

/// The sample of the take that is heard at each sample of the box, and the pulses.
void expectPlayed(SoundSource& source, int64_t count, int64_t from) {
    ASSERT_TRUE(source.restart(0));
    int64_t heard = 0, pulses = 0;
    while (heard < 3 * count) {
        const auto block = source.next();
        ASSERT_TRUE(block && *block);
        ASSERT_EQ((*block)->adc.first_sample, heard) << "no hole";
        for (const int16_t value : (*block)->adc.values) {
            const int64_t played = heard < count ? heard : from + (heard - from) % (count - from);
            ASSERT_EQ(value, played % 1000) << heard;
            ++heard;
        }
        for (const link::EmittedPulse& pulse : (*block)->pulses)
            EXPECT_EQ(pulse.sample, kBlock * pulses++);
    }
}

TEST(TakeSource, FurtherRoundsBeginWhereTheTakeSays) {
    const test::Folder folder;
    const struct {
        int seconds;
        const char* said;
        int64_t from;
    } takes[] = {{7, "1.000000", kLoopRate_hz},
                 {7, "", 0},     // says nothing
                 {7, "0.5", 0},  // no whole period of the streams is left
                 {13, "1", kLoopRate_hz},
                 {7, "-5", 0}};
    for (const auto& take : takes) {
        auto sound = openTakeSource(numberedTake(folder, take.seconds, take.said), "", true);
        ASSERT_TRUE(sound) << sound.error().text();
        SCOPED_TRACE(take.said);
        expectPlayed(*sound->source, int64_t{take.seconds} * kLoopRate_hz, take.from);
    }
}

TEST(TakeSource, ARestartFallsIntoTheMidstOfATakeThatBeganAtAnInstant) {
    constexpr int64_t kStart_ns = 5'000'000'000'000;
    const test::Folder folder;
    auto sound = openTakeSource(numberedTake(folder, 7, ""), "", false, kStart_ns);
    ASSERT_TRUE(sound) << sound.error().text();
    SoundSource& source = *sound->source;
    EXPECT_TRUE(source.isTimed());
    ASSERT_TRUE(source.restart(kStart_ns + 2'250'000'000));
    const auto block = source.next();
    ASSERT_TRUE(block && *block);
    EXPECT_EQ((*block)->adc.first_sample, 0);
    EXPECT_EQ((*block)->adc.values.front(), 9 * kLoopRate_hz / 4 % 1000);
    std::vector<int64_t> pulses;
    ASSERT_TRUE(source.restart(kStart_ns + 2'250'000'000));
    while (pulses.empty()) {
        const auto next = source.next();
        ASSERT_TRUE(next && *next);
        for (const link::EmittedPulse& pulse : (*next)->pulses)
            pulses.push_back(pulse.sample);
    }
    EXPECT_EQ(pulses.front(), kLoopRate_hz / 4) << "of 2.5 s";

    ASSERT_TRUE(source.restart(kStart_ns - 500'000'000));  // silence, then the take
    const auto heard = heardOf(source, kBlock + 3);
    ASSERT_EQ(heard.size(), kBlock + 3U);
    EXPECT_EQ(std::ranges::count(heard, 0), kBlock + 1);
    EXPECT_EQ(heard.back(), 2);
    ASSERT_TRUE(source.restart(kStart_ns + 8'000'000'000));
    EXPECT_FALSE(source.next().value()) << "all of it is over";

    auto plain = openTakeSource(numberedTake(folder, 7, "1"), "", false);
    ASSERT_TRUE(plain);
    EXPECT_FALSE(plain->source->isTimed());
}

/// The clock of the second suit was slow while it was recorded. Boxes play by the clock of the wall.
TEST(TakeSource, RoundsDoNotDependOnClocksOfTheRecording) {
    constexpr int64_t kStart_ns = 5'000'000'000'000, kTenth_ns = 100'000'000;
    const test::Folder folder;
    const std::string path = takeOfTwo(folder, 7, 0.5, 1.001);
    for (const char* subject : {"A", "B"}) {
        auto sound = openTakeSource(path, subject, true, kStart_ns);
        ASSERT_TRUE(sound) << sound.error().text();
        for (const int64_t tenths : {0, 3003}) {
            ASSERT_TRUE(sound->source->restart(kStart_ns + (10 + tenths) * kTenth_ns));
            EXPECT_EQ(heardOf(*sound->source, 1).front(), 10 + tenths % 55) << subject << " after " << tenths;
        }
    }
}

/// Whenever each box is started, both play the same time of the take, in later rounds too.
TEST(TakeSource, BoxesOfOneTakeKeepCommonTimeInAllRounds) {
    constexpr int64_t kStart_ns = 5'000'000'000'000, kTenth_ns = 100'000'000;
    const test::Folder folder;
    const std::string path = takeOfTwo(folder, 7, 0.5);
    auto first = openTakeSource(path, "A", true, kStart_ns),
         second = openTakeSource(path, "B", true, kStart_ns);
    ASSERT_TRUE(first) << first.error().text();
    ASSERT_TRUE(second) << second.error().text();
    // The first is started 2.0 s after the beginning, the second 3.4 s; compared is what follows for 20 s.
    ASSERT_TRUE(first->source->restart(kStart_ns + 20 * kTenth_ns));
    ASSERT_TRUE(second->source->restart(kStart_ns + 34 * kTenth_ns));
    constexpr size_t kLate = 14 * kLoopRate_hz / 10, kCompared = 20 * kLoopRate_hz;
    const auto of_first = heardOf(*first->source, kLate + kCompared);
    const auto of_second = heardOf(*second->source, kCompared);
    ASSERT_EQ(of_first.size(), kLate + kCompared);
    EXPECT_TRUE(std::equal(of_second.begin(), of_second.end(), of_first.begin() + kLate));
    EXPECT_EQ(of_second.front(), 34);
    // A start in the third round: the common 5.5 s from second 1 on are gone through again and again.
    ASSERT_TRUE(second->source->restart(kStart_ns + 130 * kTenth_ns));
    EXPECT_EQ(heardOf(*second->source, 1).front(), 10 + (130 - 10) % 55);
}

}  // namespace
}  // namespace noctule::virtual_suit
