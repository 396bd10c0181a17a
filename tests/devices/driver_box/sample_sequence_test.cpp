// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/sample_sequence.h"

#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {
namespace {

using Verdict = SampleSequence::Verdict;
constexpr int kSlowRate_hz = 1000;

struct Placed {
    SampleSequence::Placement placement;
    SoundBlock block;
};

Placed place(SampleSequence& sequence, int64_t first_sample, int samples, bool lossy = false,
             int boards = 2) {
    Placed placed{{}, soundBlock(first_sample, samples, boards)};
    placed.placement = sequence.place(placed.block, lossy);
    return placed;
}

TEST(SampleSequence, BlocksInOrderPassUntouched) {
    SampleSequence sequence(2, kSlowRate_hz);
    for (int64_t first = 0; first < 100; first += 10) {
        const Placed placed = place(sequence, first, 10);
        EXPECT_EQ(placed.placement.verdict, Verdict::kNew);
        EXPECT_FALSE(placed.placement.gap);
        EXPECT_EQ(placed.block, soundBlock(first, 10, 2));
    }
    EXPECT_EQ(sequence.nextSample(), 100);
    EXPECT_EQ(sequence.lostSamples(), 0);
}

TEST(SampleSequence, AHoleIsAGap) {
    SampleSequence sequence(2, kSlowRate_hz);
    EXPECT_EQ(place(sequence, 5, 10, true).placement.gap, (Gap{0, 5, GapReason::kLink}));
    EXPECT_EQ(place(sequence, 25, 10, false).placement.gap, (Gap{15, 10, GapReason::kBox}));
    EXPECT_FALSE(place(sequence, 35, 10, true).placement.gap);
    EXPECT_EQ(sequence.lostSamples(), 15);
}

TEST(SampleSequence, AnAnnouncedOverrunIsTheBoxs) {
    SampleSequence sequence(2, kSlowRate_hz);
    place(sequence, 0, 10);
    sequence.noteOverrun(10);
    EXPECT_EQ(place(sequence, 20, 10, true).placement.gap, (Gap{10, 10, GapReason::kBox}));
    EXPECT_EQ(place(sequence, 40, 10, true).placement.gap, (Gap{30, 10, GapReason::kLink}));
}

TEST(SampleSequence, OverlapsAreCutAndOldBlocksDropped) {
    SampleSequence sequence(2, kSlowRate_hz);
    place(sequence, 0, 10);
    EXPECT_EQ(place(sequence, 0, 10).placement.verdict, Verdict::kOld);
    EXPECT_EQ(place(sequence, 3, 5).placement.verdict, Verdict::kOld);
    const Placed cut = place(sequence, 6, 10);
    EXPECT_EQ(cut.placement.verdict, Verdict::kNew);
    EXPECT_FALSE(cut.placement.gap);
    EXPECT_EQ(cut.block, soundBlock(10, 6, 2));
    EXPECT_EQ(sequence.nextSample(), 16);
}

TEST(SampleSequence, WhatIsFarAheadOrOfAnotherSuitIsDamage) {
    SampleSequence sequence(2, kSlowRate_hz);
    place(sequence, 0, 10);
    EXPECT_EQ(place(sequence, 10, 10, false, 3).placement.verdict, Verdict::kDamaged);
    EXPECT_EQ(place(sequence, 9 + 60 * kSlowRate_hz + 1, 10).placement.verdict, Verdict::kDamaged);
    EXPECT_EQ(sequence.nextSample(), 10);
    EXPECT_EQ(place(sequence, 9 + 60 * kSlowRate_hz, 10).placement.verdict, Verdict::kNew);
}

TEST(SampleSequence, TheFirstBlockAfterAReconnectionMayBeFarther) {
    SampleSequence sequence(2, kSlowRate_hz);
    place(sequence, 0, 10);
    sequence.expectReconnection();
    EXPECT_EQ(place(sequence, 9 + 150 * kSlowRate_hz + 1, 10).placement.verdict, Verdict::kDamaged);
    EXPECT_EQ(place(sequence, 5, 5).placement.verdict, Verdict::kOld);
    EXPECT_EQ(place(sequence, 9 + 150 * kSlowRate_hz, 10).placement.gap,
              (Gap{10, 150 * kSlowRate_hz - 1, GapReason::kLink}));
    EXPECT_FALSE(sequence.isPlausible(sequence.nextSample() + 60 * kSlowRate_hz));
    EXPECT_TRUE(sequence.isPlausible(sequence.nextSample() + 60 * kSlowRate_hz - 1));
}

}  // namespace
}  // namespace noctule::link
