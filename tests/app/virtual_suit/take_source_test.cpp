// SPDX-License-Identifier: Apache-2.0
// A take that is made to be played again and again goes on where it says, with whole periods of the streams.
#include "app/virtual_suit/take_source.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace noctule::virtual_suit
