// SPDX-License-Identifier: Apache-2.0
#include "devices/live/stream_past.h"

#include <gtest/gtest.h>

#include "tests/devices/live/made_sound.h"

namespace noctule {
namespace {

constexpr int64_t kPiece = 600;

StreamEvent soundAt(int64_t first) {
    return test::madeBlock(first, kPiece, 1);
}

StreamEvent batteryAt(int64_t sample, float percent) {
    link::BoxStatus status;
    status.sample = sample;
    status.battery_percent = percent;
    return status;
}

/// "s600" sound, "g1200+600" gap, "p7" pulse, "b55" status: in the order in which they are told.
std::string told(const std::vector<StreamEvent>& events) {
    std::string text;
    for (const StreamEvent& event : events) {
        if (const auto* block = std::get_if<ArrivedBlock>(&event))
            text += "s" + std::to_string(block->firstSample()) + " ";
        if (const auto* gap = std::get_if<link::Gap>(&event))
            text += "g" + std::to_string(gap->first_sample) + "+" + std::to_string(gap->sample_count) + " ";
        if (const auto* pulses = std::get_if<link::Pulses>(&event))
            for (const link::EmittedPulse& pulse : *pulses)
                text += "p" + std::to_string(pulse.sample) + " ";
        if (const auto* status = std::get_if<link::BoxStatus>(&event))
            text += "b" + std::to_string(static_cast<int>(*status->battery_percent)) + " ";
        if (std::holds_alternative<link::BoxError>(event))
            text += "e ";
    }
    return text;
}

TEST(StreamPast, ABeginningLiesWithTheBlockOfItsSample) {
    StreamPast past(1'000'000);
    EXPECT_EQ(past.boundaryAt(0), 0);
    for (const int64_t first : {0, 600, 1200})
        past.add(soundAt(first));
    EXPECT_EQ(past.endSample(), 1800);
    EXPECT_EQ(past.boundaryAt(-5), 0);
    EXPECT_EQ(past.boundaryAt(599), 0);
    EXPECT_EQ(past.boundaryAt(600), 600);
    EXPECT_EQ(past.boundaryAt(1799), 1200);
    EXPECT_EQ(past.boundaryAt(1800), 1800) << "with the next that comes";
}

TEST(StreamPast, ABeginningInAHoleLiesAfterIt) {
    StreamPast past(1'000'000);
    past.add(soundAt(0));
    past.add(link::Gap{600, 1200, link::GapReason::kLink});
    past.add(soundAt(1800));
    EXPECT_EQ(past.boundaryAt(700), 1800);
    EXPECT_EQ(told(past.since(1800)), "s1800 ");
    EXPECT_EQ(told(past.since(0)), "s0 g600+1200 s1800 ");
    EXPECT_EQ(told(past.since(600)), "g600+1200 s1800 ") << "asked for before the hole, told after it";
}

TEST(StreamPast, TellsHowTheSuitWasAndWhatIsAnnounced) {
    StreamPast past(1'000'000);
    past.add(batteryAt(0, 90));
    past.add(link::Pulses{{0, 0}, {1300, 1}});
    past.add(soundAt(0));
    past.add(batteryAt(600, 80));
    past.add(link::BoxError{link::Code::kBoardLost, 600, "l_foot"});
    past.add(soundAt(600));
    past.add(link::Pulses{{1900, 2}});
    past.add(soundAt(1200));
    past.add(batteryAt(1800, 70));
    past.add(soundAt(1800));
    EXPECT_EQ(told(past.since(1200)), "b80 p0 p1300 p1900 s1200 b70 s1800 ");
    EXPECT_EQ(told(past.since(0)), "b90 p0 p1300 s0 b80 e s600 p1900 s1200 b70 s1800 ");
}

TEST(StreamPast, ForgetsWhatIsOldAndStillKnowsWhatItMeans) {
    StreamPast past(2 * kPiece);
    past.add(batteryAt(0, 90));
    past.add(link::Pulses{{0, 0}, {6100, 1}});
    std::weak_ptr<const link::SoundBlock> first_sound;
    for (int64_t first = 0; first < 6600; first += kPiece) {
        const StreamEvent block = soundAt(first);
        if (first == 0)
            first_sound = std::get<ArrivedBlock>(block).sound;
        past.add(block);
    }
    EXPECT_TRUE(first_sound.expired()) << "memory is bounded";
    EXPECT_EQ(past.boundaryAt(0), 5400) << "the oldest that is held";
    EXPECT_EQ(told(past.since(5400)), "b90 p6100 s5400 s6000 ");
    for (int64_t first = 6600; first < 9000; first += kPiece)
        past.add(soundAt(first));
    EXPECT_EQ(told(past.since(8400)), "b90 s8400 ") << "the announced pulse has passed";
}

}  // namespace
}  // namespace noctule
