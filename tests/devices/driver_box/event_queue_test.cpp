// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/event_queue.h"

#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {
namespace {

TEST(EventQueue, KeepsOrderAndTwoSecondsOfSound) {
    EventQueue queue;
    queue.push(Greeted{testHello()});
    queue.push(Started{});
    queue.push(Gap{0, 600, GapReason::kLink});
    for (int64_t first = 600; first < 600 * 602; first += 600) {
        if (first == 600 * 50)
            queue.push(BoxStatus{});
        queue.push(soundBlock(first, 600, 2));
    }
    // 601 blocks were pushed, 500 fit.
    EXPECT_EQ(queue.heldSamples(), 300'000);
    EXPECT_EQ(queue.droppedSamples(), 101 * 600);
    LinkSimulation checker;
    checker.events = queue.takeAll();
    EXPECT_EQ(eventsOf<Gap>(checker.events), (std::vector<Gap>{{0, 600, GapReason::kLink},
                                                               {600, 49 * 600, GapReason::kStudio},
                                                               {50 * 600, 52 * 600, GapReason::kStudio}}));
    EXPECT_EQ(checker.expectWholeTake(), 600 * 602);
    EXPECT_EQ(countOf<BoxStatus>(checker.events), 1u);
    EXPECT_EQ(countOf<Started>(checker.events), 1u);
    EXPECT_EQ(queue.heldSamples(), 0);
    EXPECT_TRUE(queue.takeAll().empty());
}

TEST(EventQueue, NothingIsDroppedFromAQueueThatIsRead) {
    EventQueue queue;
    queue.push(Greeted{testHello()});
    size_t taken = 0;
    for (int64_t first = 0; first < 600 * 2000; first += 600) {
        queue.push(soundBlock(first, 600, 2));
        if (first % 6000 == 0)
            taken += queue.takeAll().size();
    }
    EXPECT_EQ(queue.droppedSamples(), 0);
    EXPECT_EQ(taken + queue.takeAll().size(), 2001u);
}

TEST(EventQueue, GapsAreNamedAsInTakes) {
    EXPECT_STREQ(nameOf(GapReason::kLink), "link");
    EXPECT_STREQ(nameOf(GapReason::kBox), "box");
    EXPECT_STREQ(nameOf(GapReason::kStudio), "studio");
}

}  // namespace
}  // namespace noctule::link
