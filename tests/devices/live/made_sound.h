// SPDX-License-Identifier: Apache-2.0
// Sound whose every value tells where it belongs, and devices that stand for a box in tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "core/recording/take.h"
#include "core/suit/default_suit.h"
#include "devices/live/take_sink.h"

namespace noctule::test {

inline constexpr int kMadeRate_hz = 150000;

/// Never 0, so that no board seems to be unplugged.
inline int16_t madeValue(int64_t sample, int board) {
    const auto mixed = static_cast<uint64_t>(sample * 32 + board + 1) * 0x9E3779B97F4A7C15U;
    return static_cast<int16_t>((mixed >> 52) + 1);
}

inline ArrivedBlock madeBlock(int64_t first, int64_t count, int boards) {
    link::SoundBlock block{first, boards, {}};
    block.values.reserve(static_cast<size_t>(count * boards));
    for (int64_t sample = first; sample < first + count; ++sample)
        for (int board = 0; board < boards; ++board)
            block.values.push_back(madeValue(sample, board));
    return {std::make_shared<const link::SoundBlock>(std::move(block)), 0};
}

inline TakeHeader madeHeader(int boards) {
    TakeHeader header;
    header.created_utc = "2026-01-01T00:00:00Z";
    header.software = "test";
    header.sample_rate_hz = kMadeRate_hz;
    header.board_count = boards;
    header.source_count = 8;
    return header;
}

inline Suit suitOf(int boards) {
    Suit suit = defaultSuit();
    suit.boards.resize(static_cast<size_t>(boards));
    return suit;
}

inline TakePlan madePlan(const std::filesystem::path& folder, int boards) {
    TakePlan plan;
    plan.folder = folder;
    plan.name = "walk";
    plan.header = madeHeader(boards);
    plan.suit = suitOf(boards);
    return plan;
}

struct MadeSoundInTake {
    int64_t samples = 0, end = 0, holes = 0, wrong_values = 0;
};

/// What of the made sound a take holds.
inline MadeSoundInTake readMadeSound(const Take& take, int boards) {
    MadeSoundInTake found;
    const Status read = take.forEachBlock(1, [&](const AdcBlock& block) {
        found.holes += block.first_sample - found.end;
        const auto count = static_cast<int64_t>(block.values.size()) / boards;
        for (size_t i = 0; i < block.values.size(); ++i)
            found.wrong_values +=
                block.values[i] != madeValue(block.first_sample + static_cast<int64_t>(i) / boards,
                                             static_cast<int>(i % static_cast<size_t>(boards)));
        found.samples += count;
        found.end = block.first_sample + count;
        return true;
    });
    EXPECT_TRUE(read);
    EXPECT_TRUE(take.skippedRows().empty());
    return found;
}

}  // namespace noctule::test
