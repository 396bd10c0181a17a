// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/sample_history.h"

#include <gtest/gtest.h>

#include <numeric>

namespace noctule {
namespace {

/// Samples first..end of two boards: 2 i and 2 i + 1.
std::vector<int16_t> block(int first, int end) {
    std::vector<int16_t> values(size_t(2 * (end - first)));
    std::iota(values.begin(), values.end(), int16_t(2 * first));
    return values;
}

TEST(SampleHistory, GivesWindowsAcrossBlocksAndNothingBeyond) {
    SampleHistory history(2, 100);
    history.push(0, block(0, 7));
    history.push(7, block(7, 20));
    const auto window = history.window(5, 4);
    EXPECT_EQ(std::vector<int16_t>(window.begin(), window.end()), block(5, 9));
    EXPECT_TRUE(history.window(18, 3).empty());
    EXPECT_EQ(history.missingBoards(0, 20), 0u);
}

TEST(SampleHistory, WhatIsPushedTwiceIsIgnored) {
    SampleHistory history(2, 100);
    history.push(0, block(0, 10));
    history.push(3, block(13, 15));  // other values for known samples
    history.push(8, block(8, 12));   // two known, two new
    EXPECT_EQ(history.end(), 12);
    const auto window = history.window(0, 12);
    EXPECT_EQ(std::vector<int16_t>(window.begin(), window.end()), block(0, 12));
}

TEST(SampleHistory, HolesAndMarksAreMissing) {
    SampleHistory history(2, 100);
    history.markMissing(12, 3, 1);  // before the samples come
    history.push(0, block(0, 5));
    history.push(8, block(8, 20));
    EXPECT_EQ(history.missingBoards(0, 5), 0u);
    EXPECT_EQ(history.missingBoards(4, 2), ~0u);
    EXPECT_EQ(history.missingBoards(8, 4), 0u);
    EXPECT_EQ(history.missingBoards(14, 4), 2u);
    EXPECT_EQ(history.missingBoards(15, 4), 0u);
}

TEST(SampleHistory, KeepsNoMoreThanItsLimit) {
    SampleHistory history(2, 50);
    for (int first = 0; first < 1000; first += 10)
        history.push(first, block(first, first + 10));
    EXPECT_EQ(history.begin(), 950);
    EXPECT_TRUE(history.window(949, 5).empty());
    const auto window = history.window(960, 2);
    EXPECT_EQ(std::vector<int16_t>(window.begin(), window.end()), block(960, 962));
}

TEST(SampleHistory, AGiganticHoleCostsNoMemory) {
    SampleHistory history(2, 50);
    history.push(0, block(0, 10));
    history.push(int64_t(1) << 50, block(0, 10));
    EXPECT_EQ(history.begin(), int64_t(1) << 50);
    EXPECT_EQ(history.window(int64_t(1) << 50, 10).size(), 20u);
    EXPECT_TRUE(history.window(5, 10).empty());
}

}  // namespace
}  // namespace noctule
