// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_queue.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/devices/live/made_sound.h"

namespace noctule {
namespace {

using std::chrono::steady_clock;

std::vector<LiveItem> popAll(LiveQueue& queue) {
    std::vector<LiveItem> items;
    while (auto item = queue.pop(steady_clock::now()))
        items.push_back(std::move(*item));
    return items;
}

GapRow gapAt(const std::vector<LiveItem>& items, size_t index) {
    EXPECT_TRUE(std::holds_alternative<GapRow>(items.at(index))) << index;
    return std::get<GapRow>(items.at(index));
}

TEST(LiveQueue, KeepsTheOrderAndTellsItsDepth) {
    LiveQueue queue(1000, LiveQueue::WhenFull::kOldestGoes);
    queue.push(std::vector<Pulse>{{1, 5, 0}});
    queue.push(test::madeBlock(0, 600, 2));
    queue.push(StatusRow{600, {}, {}, {}, {}});
    EXPECT_EQ(queue.depth().samples, 600);
    const auto items = popAll(queue);
    ASSERT_EQ(items.size(), 3u);
    EXPECT_EQ(items[0].index(), 1u);
    EXPECT_EQ(items[1].index(), 0u);
    EXPECT_EQ(items[2].index(), 3u);
    EXPECT_EQ(queue.depth().samples, 0);
    EXPECT_EQ(queue.depth().deepest_samples, 600);
}

TEST(LiveQueue, TheOldestSoundGoesAndOneGapOfTheStudioStandsInItsPlace) {
    LiveQueue queue(1200, LiveQueue::WhenFull::kOldestGoes);
    queue.push(NoteRow{"", "first"});
    for (int64_t block = 0; block < 5; ++block) {
        queue.push(std::vector<Pulse>{{block + 1, block * 600, 0}});
        queue.push(test::madeBlock(block * 600, 600, 2));
    }
    const auto items = popAll(queue);
    ASSERT_EQ(items.size(), 1u + 5 + 1 + 2);
    const GapRow gap = gapAt(items, 2);
    EXPECT_EQ(gap.first_sample, 0);
    EXPECT_EQ(gap.sample_count, 1800);
    EXPECT_EQ(gap.reason, "studio");
    EXPECT_FALSE(gap.board);
    EXPECT_EQ(std::get<ArrivedBlock>(items[6]).firstSample(), 1800);
    EXPECT_EQ(std::get<ArrivedBlock>(items[8]).firstSample(), 2400);
    EXPECT_EQ(queue.depth().dropped_samples, 1800);
    EXPECT_EQ(queue.depth().deepest_samples, 1200);
}

TEST(LiveQueue, OneLongGapForAReaderThatNeedsSoundInOnePiece) {
    LiveQueue queue(1800, LiveQueue::WhenFull::kNewestStays);
    for (int64_t block = 0; block < 6; ++block)
        queue.push(test::madeBlock(block * 600, 600, 2));
    const auto items = popAll(queue);
    ASSERT_EQ(items.size(), 1u + 3);
    EXPECT_EQ(gapAt(items, 0).first_sample, 0);
    EXPECT_EQ(gapAt(items, 0).sample_count, 1800);
    EXPECT_EQ(std::get<ArrivedBlock>(items[1]).firstSample(), 1800);
    EXPECT_EQ(queue.depth().dropped_samples, 1800);
}

TEST(LiveQueue, AGapThatHasBeenReadDoesNotGrow) {
    LiveQueue queue(600, LiveQueue::WhenFull::kOldestGoes);
    for (int64_t block = 0; block < 2; ++block)
        queue.push(test::madeBlock(block * 600, 600, 1));
    EXPECT_EQ(gapAt({*queue.pop(steady_clock::now())}, 0).sample_count, 600);
    queue.push(test::madeBlock(1200, 600, 1));
    EXPECT_EQ(gapAt({*queue.pop(steady_clock::now())}, 0).first_sample, 600);
    // A hole that the link made lies between: two gaps.
    queue.push(GapRow{1800, 600, {}, "link"});
    queue.push(test::madeBlock(2400, 600, 1));
    queue.push(test::madeBlock(3000, 600, 1));
    const auto items = popAll(queue);
    ASSERT_EQ(items.size(), 4u);
    EXPECT_EQ(gapAt(items, 0).first_sample, 1200);
    EXPECT_EQ(gapAt(items, 1).reason, "link");
    EXPECT_EQ(gapAt(items, 2).first_sample, 2400);
    EXPECT_EQ(gapAt(items, 2).sample_count, 600);
}

TEST(LiveQueue, ClosesAndIsAbandoned) {
    LiveQueue queue(600, LiveQueue::WhenFull::kOldestGoes);
    std::thread reader([&] {
        while (!queue.drained())
            queue.pop(steady_clock::now() + std::chrono::hours(1));
    });
    queue.push(test::madeBlock(0, 600, 1));
    queue.close();
    reader.join();
    LiveQueue left(600, LiveQueue::WhenFull::kOldestGoes);
    left.push(test::madeBlock(0, 600, 1));
    left.abandon();
    left.push(test::madeBlock(600, 600, 1));
    EXPECT_TRUE(left.drained());
    EXPECT_EQ(left.depth().samples, 0);
    EXPECT_EQ(left.depth().dropped_samples, 600);
    EXPECT_FALSE(left.pop(steady_clock::now()));
}

}  // namespace
}  // namespace noctule
