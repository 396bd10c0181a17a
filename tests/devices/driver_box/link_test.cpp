// SPDX-License-Identifier: Apache-2.0
// Both sides of the link against each other, over a wire that is cut, slow and lossy.
#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {
namespace {

constexpr int64_t kRate_hz = 150'000;

void start(LinkSimulation& link) {
    link.connect();
    link.run(0.1);
    link.studio.start(link.now_ns);
}

TEST(Link, ACleanTakeIsWhole) {
    LinkSimulation link;
    start(link);
    link.run(5);
    link.studio.stop(link.now_ns);
    link.run(0.1);
    EXPECT_EQ(countOf<Greeted>(link.events), 1u);
    EXPECT_EQ(countOf<Started>(link.events), 1u);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    EXPECT_EQ(countOf<Gap>(link.events), 0u);
    EXPECT_EQ(countOf<BoxStatus>(link.events), 5u);
    const int64_t end = link.expectWholeTake();
    EXPECT_EQ(end, link.box->nextSample());
    EXPECT_NEAR(static_cast<double>(end), 5.0 * kRate_hz, 1200);
    EXPECT_EQ(link.expectPulses(), static_cast<size_t>((end + 1199) / 1200));
    EXPECT_EQ(link.studio.statistics().frames.losses(), 0);
    EXPECT_EQ(link.studio.statistics().round_trip_ns, 0);
    // A second take begins at 0 again.
    link.events.clear();
    link.studio.start(link.now_ns);
    link.run(0.5);
    EXPECT_GT(link.expectWholeTake(), 0);
}

TEST(Link, APulseComesBeforeItsSound) {
    LinkSimulation link;
    link.bytes_per_step = 900;  // far too slow: sound is dropped, pulses are not
    start(link);
    link.run(2);
    int64_t sound_end = 0;
    for (const StudioEvent& event : link.events) {
        if (const auto* block = std::get_if<SoundBlock>(&event))
            sound_end = block->first_sample + block->sampleCount();
        if (const auto* pulses = std::get_if<Pulses>(&event)) {
            for (const EmittedPulse& pulse : *pulses)
                EXPECT_GE(pulse.sample, sound_end);
        }
    }
    EXPECT_GT(sound_end, 0);
    EXPECT_GT(link.expectPulses(), 100u);
}

TEST(Link, ALossyWireLosesSoundButNeverTime) {
    for (uint32_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(seed);
        LinkSimulation link(seed);
        start(link);
        link.run(0.1);
        link.damage_per_byte = 3e-5;  // every thirteenth block
        link.run(20);
        link.damage_per_byte = 0;
        link.run(2);
        link.studio.stop(link.now_ns);
        link.run(1);
        EXPECT_EQ(countOf<Stopped>(link.events), 1u);
        EXPECT_EQ(countOf<TakeEnded>(link.events), 0u);
        const int64_t end = link.expectWholeTake();
        EXPECT_EQ(end, link.box->nextSample());
        EXPECT_LE(link.expectPulses(), static_cast<size_t>((end + 1199) / 1200));
        const LinkStatistics counts = link.studio.statistics();
        EXPECT_GT(counts.lost_samples, 0);
        EXPECT_LT(counts.lost_samples, end / 4);
        EXPECT_GT(counts.frames.losses(), 0);
        for (const Gap& gap : eventsOf<Gap>(link.events))
            EXPECT_EQ(gap.reason, GapReason::kLink);
    }
}

TEST(Link, TooSlowAWireMakesGapsOfTheBox) {
    LinkSimulation link;
    start(link);
    link.run(1);
    link.bytes_per_step = 1500;  // a block needs 2440
    link.run(5);
    link.bytes_per_step = 1'000'000;
    link.run(2);
    link.studio.stop(link.now_ns);
    link.run(0.1);
    const int64_t end = link.expectWholeTake();
    EXPECT_EQ(link.expectPulses(), static_cast<size_t>((end + 1199) / 1200));
    EXPECT_GT(countOf<Gap>(link.events), 0u);
    for (const Gap& gap : eventsOf<Gap>(link.events))
        EXPECT_EQ(gap.reason, GapReason::kBox);
    const std::vector<BoxError> errors = eventsOf<BoxError>(link.events);
    ASSERT_FALSE(errors.empty());
    EXPECT_EQ(errors[0].code, Code::kOverrun);
    EXPECT_EQ(errors[0].sample, eventsOf<Gap>(link.events)[0].first_sample);
    EXPECT_EQ(eventsOf<BoxStatus>(link.events).back().dropped_samples, link.studio.statistics().lost_samples);
    EXPECT_EQ(link.studio.statistics().frames.lost_frames, 0);
}

TEST(Link, ACutCableResumesWithAHole) {
    LinkSimulation link;
    start(link);
    link.run(2);
    link.cut();
    link.run(6);
    link.cable = true;
    link.run(6);
    link.studio.stop(link.now_ns);
    link.run(0.1);
    EXPECT_EQ(countOf<Resumed>(link.events), 1u);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    EXPECT_EQ(countOf<TakeEnded>(link.events), 0u);
    const auto gaps = eventsOf<Gap>(link.events);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].reason, GapReason::kLink);
    // Out for 7.5 s (0.5 + 1 + 2 + 4), the last second of it still in the box.
    EXPECT_NEAR(static_cast<double>(gaps[0].sample_count), 6.5 * kRate_hz, 0.05 * kRate_hz);
    const int64_t end = link.expectWholeTake();
    EXPECT_NEAR(static_cast<double>(end), 14.0 * kRate_hz, 0.1 * kRate_hz);
    EXPECT_EQ(link.expectPulses(), static_cast<size_t>((end + 1199) / 1200));
    EXPECT_EQ(link.studio.statistics().reconnections, 1);
}

TEST(Link, AHoleOfTwoMinutesIsStillTheSameTake) {
    LinkSimulation link;
    start(link);
    link.run(1);
    link.cut();
    link.run(115);
    link.cable = true;
    link.run(6);
    EXPECT_EQ(countOf<Resumed>(link.events), 1u);
    EXPECT_GT(link.expectWholeTake(), 119 * kRate_hz);
    EXPECT_EQ(link.studio.statistics().bad_content, 0);
}

TEST(Link, AfterTwoMinutesAloneTheTakeEnds) {
    LinkSimulation link;
    start(link);
    link.run(1);
    link.cut();
    link.run(121);
    link.cable = true;
    link.run(6);
    EXPECT_EQ(countOf<Resumed>(link.events), 0u);
    EXPECT_EQ(countOf<TakeEnded>(link.events), 1u);
    EXPECT_EQ(link.studio.state(), StudioConversation::State::kIdle);
}

TEST(Link, ASilentWireIsLostAndResumed) {
    LinkSimulation link;
    start(link);
    link.run(1);
    link.swallow = true;
    link.run(3.2);
    EXPECT_EQ(countOf<Stalled>(link.events), 1u);
    EXPECT_EQ(countOf<LinkLost>(link.events), 1u);
    link.swallow = false;
    link.run(2);
    EXPECT_EQ(countOf<Resumed>(link.events), 1u);
    EXPECT_EQ(countOf<Gap>(link.events), 1u);
    link.expectWholeTake();
}

TEST(Link, ARestartedBoxEndsTheTakeAndTheNextIsClean) {
    for (const bool silently : {false, true}) {
        LinkSimulation link;
        start(link);
        link.run(2);
        if (silently)
            link.restartBoxSilently();
        else
            link.restartBox();
        link.run(6);
        EXPECT_EQ(countOf<TakeEnded>(link.events), 1u);
        EXPECT_EQ(countOf<Gap>(link.events), 0u);
        EXPECT_NEAR(static_cast<double>(link.expectWholeTake()), 2.0 * kRate_hz, 1200);
        ASSERT_EQ(link.studio.state(), StudioConversation::State::kIdle);
        link.events.clear();
        link.studio.start(link.now_ns);
        link.run(1);
        EXPECT_EQ(countOf<Started>(link.events), 1u);
        EXPECT_NEAR(static_cast<double>(link.expectWholeTake()), kRate_hz, 1200);
    }
}

TEST(Link, StoppedWithoutALinkTheBoxIsClearedBeforeTheNextTake) {
    LinkSimulation link;
    start(link);
    link.run(1);
    link.cut();
    link.run(0.1);
    link.studio.stop(link.now_ns);
    link.run(0.1);
    EXPECT_EQ(countOf<Stopped>(link.events), 1u);
    link.cable = true;
    link.run(1);
    EXPECT_EQ(countOf<Resumed>(link.events), 0u);
    EXPECT_TRUE(link.box->streaming());
    link.events.clear();
    link.studio.start(link.now_ns);
    link.run(1);
    EXPECT_EQ(countOf<Started>(link.events), 1u);
    EXPECT_EQ(countOf<Gap>(link.events), 0u);
    EXPECT_GT(link.expectWholeTake(), kRate_hz / 2);
}

TEST(Link, EverythingGoesWrongAtRandom) {
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        LinkSimulation link(seed);
        start(link);
        link.run(0.1);
        for (int i = 0; i < 15; ++i) {
            link.damage_per_byte = link.random() % 3 == 0 ? 1e-4 : 0;
            link.bytes_per_step = link.random() % 3 == 0 ? 1500 : 1'000'000;
            link.swallow = link.random() % 8 == 0;
            link.cable = true;
            if (link.random() % 6 == 0)
                link.cut();
            link.run(0.2 + static_cast<double>(link.random() % 4));
        }
        link.damage_per_byte = 0;
        link.bytes_per_step = 1'000'000;
        link.swallow = false;
        link.cable = true;
        link.run(12);
        EXPECT_TRUE(link.studio.takeIsOpen());
        EXPECT_EQ(countOf<TakeEnded>(link.events), 0u);
        link.studio.stop(link.now_ns);
        link.run(0.2);
        EXPECT_EQ(countOf<Stopped>(link.events), 1u);
        EXPECT_EQ(link.expectWholeTake(), link.box->nextSample());
        link.expectPulses();
    }
}

}  // namespace
}  // namespace noctule::link
