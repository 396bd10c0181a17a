// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_clocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/processing/cross_clocks.h"
#include "core/recording/take_edit.h"
#include "core/recording/take_writer.h"

namespace noctule {
namespace {

constexpr double kFs_hz = 150000, kSound_m_per_s = 344;
// Suit 2's true clock; the take says 3 ms less and rate 1.
constexpr double kOffset_s = 0.012, kRate = 1 + 15e-6, kGuess_s = 0.009;

Suit transceivers(const std::string& name, bool room) {
    Suit suit;
    suit.name = name;
    for (const char* id : {"a", "b", "c"}) {
        Board board;
        board.id = id;
        board.segment = room ? "" : "Chest";
        suit.boards.push_back(board);
        Source source;
        source.id = std::string(id) + "_source";
        source.segment = board.segment;
        source.board = id;
        suit.sources.push_back(source);
    }
    return suit;
}

/// Way of sound between two housings, which sways.
double way_m(int i, int j, double take_s) {
    return 1.5 + 0.1 * i - 0.07 * j + 0.2 * std::sin(1.5 * take_s);
}

/// Two suits hear each other, and themselves; `both`: in both directions; `corrected`: distances are by the
/// true clocks, not by the guess.
std::string takeOfTwo(const std::string& name, bool both, double guess_s = kGuess_s, bool corrected = false) {
    const std::string path = (std::filesystem::path(::testing::TempDir()) / name).string();
    std::filesystem::remove(path);
    TakeHeader header;
    header.uuid = "00000000-0000-4000-8000-000000000037";
    header.name = name;
    header.created_utc = "2026-11-26T08:00:00Z";
    header.sample_rate_hz = 150000;
    header.board_count = header.source_count = 3;
    auto take = TakeWriter::create(path, header);
    EXPECT_TRUE(take);
    EXPECT_TRUE(take->setMeta("level", "readings"));
    EXPECT_TRUE(take->addSuit(transceivers("one", false)));
    EXPECT_TRUE(take->addSuit(transceivers("room", true), SuitClock{guess_s * 1e9, 1}));
    for (int pulse = 0; pulse < 1250; ++pulse)
        for (int from = 1; from <= 2; ++from) {
            const int64_t sample = int64_t{pulse} * (from == 1 ? 1200 : 1230);
            const int source = pulse % 3;
            const double own_s = static_cast<double>(sample) / kFs_hz;
            const double take_s = from == 1 ? own_s : kOffset_s + kRate * own_s;
            const auto id = take->addPulse(sample, source, from);
            EXPECT_TRUE(id);
            RangeMeasurement own;
            own.pulse = *id;
            own.board = 0;
            own.arrival_sample = static_cast<double>(sample) + 400;
            own.distance_m = 0.5;
            own.w_s = own.w_t = 1;
            EXPECT_TRUE(take->addRange(kPrimaryRun, own, "inflection", from));
            for (int board = 0; board < 3 && (both || from == 1); ++board) {
                // The room stands still: the way is that of the instant at suit 1.
                double flight_s =
                    way_m(from == 1 ? source : board, from == 1 ? board : source, take_s) / kSound_m_per_s;
                if (from == 2)
                    for (int i = 0; i < 5; ++i)
                        flight_s = way_m(board, source, take_s + flight_s) / kSound_m_per_s;
                RangeMeasurement range = own;
                range.board = board;
                const double arrival_take_s = take_s + flight_s;
                const double arrival_s = from == 1 ? (arrival_take_s - kOffset_s) / kRate : arrival_take_s;
                range.arrival_sample = arrival_s * kFs_hz;
                const double believed_s =
                    from == 1 ? guess_s + arrival_s - own_s : arrival_s - (guess_s + own_s);
                range.distance_m = (corrected ? flight_s : believed_s) * kSound_m_per_s;
                range.sigma_m = 0.002;
                EXPECT_TRUE(take->addRange(kPrimaryRun, range, "inflection", 3 - from));
            }
        }
    EXPECT_TRUE(take->finish());
    return path;
}

TEST(TakeClocks, TwoWayRangesJoinTheSuits) {
    const auto take = Take::open(takeOfTwo("two_way.noctule", true));
    ASSERT_TRUE(take);
    const auto clocks = joinClocks(*take, {});
    ASSERT_TRUE(clocks) << clocks.error().text();
    EXPECT_TRUE(clocks->warnings.empty());
    ASSERT_TRUE(clocks->tracks.contains(2));
    for (const ClockRow& row : clockRows(clocks->tracks.at(2))) {
        const double suit_s = static_cast<double>(row.time_ns) * 1e-9;
        if (suit_s <= 0)
            continue;
        EXPECT_NEAR(row.offset_ns, (kOffset_s + (kRate - 1) * suit_s) * 1e9, 500) << suit_s;
    }
    EXPECT_NEAR(clocks->lines.at(2).rate, kRate, 0.1e-6);
}

/// Whoever writes a take may state distances by clocks of its own: here 0.2 ms and 3 ms better than the
/// guess.
TEST(TakeClocks, DistancesByOtherClocksThanTheGuessAreNoticed) {
    for (const double guess_s : {kOffset_s - 0.0002, kGuess_s}) {
        const auto take = Take::open(takeOfTwo("corrected.noctule", true, guess_s, true));
        ASSERT_TRUE(take);
        const auto clocks = joinClocks(*take, {});
        ASSERT_TRUE(clocks && clocks->tracks.contains(2));
        EXPECT_NEAR(clocks->lines.at(2).offset_ns, kOffset_s * 1e9, 500);
        const auto cross = CrossClocks::of(*take, *clocks);
        ASSERT_TRUE(cross) << cross.error().text();
        int seen = 0;
        ASSERT_TRUE(take->forEachCrossRange(kPrimaryRun, 2, [&](const Take::CrossRange& of) {
            const double by_guess_m = cross->byGuess_m(1, 2, of.range, kSound_m_per_s);
            EXPECT_NEAR(by_guess_m - of.range.distance_m, (guess_s - kOffset_s) * kSound_m_per_s, 0.002);
            return ++seen < 20;
        }));
        EXPECT_EQ(seen, 20);
    }
}

TEST(TakeClocks, OneDirectionAloneIsSaid) {
    const auto take = Take::open(takeOfTwo("one_way.noctule", false));
    ASSERT_TRUE(take);
    const auto clocks = joinClocks(*take, {});
    ASSERT_TRUE(clocks);
    EXPECT_TRUE(clocks->tracks.empty());
    ASSERT_EQ(clocks->warnings.size(), 1u);
    EXPECT_NE(clocks->warnings[0].find("suit 2"), std::string::npos);
}

TEST(TakeClocks, PulsesOfOthersAreNoOwnRanges) {
    const auto take = Take::open(takeOfTwo("own.noctule", true));
    ASSERT_TRUE(take);
    auto ranges = take->ranges(kPrimaryRun, 1);
    ASSERT_TRUE(ranges);
    int count = 0;
    for (auto range = ranges->next(); range && *range; range = ranges->next(), ++count)
        EXPECT_EQ((*range)->distance_m, 0.5);
    EXPECT_EQ(count, 1250);
}

TEST(TakeClocks, RowsAreReadAsWritten) {
    const std::string path = takeOfTwo("rows.noctule", true);
    auto take = Take::open(path, Access::kReadWrite);
    ASSERT_TRUE(take);
    auto edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit);
    const auto run = edit->beginRun({0, "clock", "AGD", "2026-11-26T08:00:00Z", "test", "{}", {}, {}});
    ASSERT_TRUE(run);
    ASSERT_TRUE(edit->addClock(*run, {1'000'000, 12.5, 1.00001, 300}, 2));
    ASSERT_TRUE(edit->commit());
    const auto rows = take->clocks(*run, 2);
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 1u);
    EXPECT_EQ(rows->front().time_ns, 1'000'000);
    EXPECT_EQ(rows->front().offset_ns, 12.5);
    EXPECT_EQ(rows->front().rate, 1.00001);
    EXPECT_TRUE(take->clocks(*run, 1)->empty());
    auto drop = TakeEdit::begin(*take);
    ASSERT_TRUE(drop->dropRun(*run));
    ASSERT_TRUE(drop->commit());
    EXPECT_TRUE(take->clocks(*run, 2)->empty());
}

}  // namespace
}  // namespace noctule
