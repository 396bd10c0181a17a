// SPDX-License-Identifier: Apache-2.0
#include "core/report/joint_support.h"

#include <gtest/gtest.h>

#include "core/report/range_statistics.h"
#include "tests/core/report/made_report.h"

namespace noctule {
namespace {

using namespace test;

TEST(RangeStatistics, CountsFatesAndGaps) {
    ReportPair pair{0, 0, {}};
    const PulseFate fates[] = {PulseFate::kUsed,    PulseFate::kRejected, PulseFate::kOccluded,
                               PulseFate::kMissing, PulseFate::kUsed,     PulseFate::kUnused};
    for (int i = 0; i < 6; ++i)
        pair.pulses.push_back(
            {static_cast<float>(i), fates[i], i == 0 ? 0.5f : 1.0f, 1.0f, i == 0 ? 0.003f : 0.004f});
    const RangeStatistics s = rangeStatistics(pair);
    EXPECT_EQ(s.pulses(), 6);
    EXPECT_EQ(s.heard(), 4);
    EXPECT_EQ(s.of(PulseFate::kUsed), 2);
    EXPECT_DOUBLE_EQ(s.longest_gap_s, 4);
    EXPECT_NEAR(*s.residualRms_m(), 0.0035355, 1e-6);
    EXPECT_NEAR(s.meanConfidence(), 5.5 / 6, 1e-9);
    EXPECT_FALSE(rangeStatistics(ReportPair{}).residualRms_m());
}

TEST(JointSupport, ARangeBacksTheJointsBetweenItsEnds) {
    Suit suit;
    suit.boards = {{"l_hand", "", "LeftHand"}, {"head", "", "Head"}};
    suit.sources = {{"s1", "", "Chest"}, {"s2", "", "Hips"}};
    ReportPair pair{0, 0, {}};  // chest to left hand, used in the first half of ten seconds
    for (int i = 0; i < 10; ++i)
        pair.pulses.push_back({0.5f * static_cast<float>(i), PulseFate::kUsed, 1, 1, 0});
    ReportTake take;
    take.duration_s = 10;
    auto support = jointSupport(defaultActor().skeleton, suit, {pair}, {1.0, 0.5}, take, 0.6);
    const auto of = [&](const std::string& name) {
        return *std::find_if(support.begin(), support.end(),
                             [&](const JointSupport& s) { return s.joint == name; });
    };
    for (const char* joint : {"LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"}) {
        EXPECT_NEAR(of(joint).ranges, 0.51, 0.01) << joint;
        EXPECT_NEAR(of(joint).inertia, 0.49, 0.01) << joint;
    }
    EXPECT_EQ(of("Chest").ranges, 0) << "both ends turn with the chest";
    EXPECT_EQ(of("Head").ranges, 0);
    EXPECT_EQ(of("Head").inertia, 0.5);
    EXPECT_EQ(of("Spine").inertia, 1);
    EXPECT_EQ(of("RightArm").alone(), 1);
    EXPECT_EQ(support.size(), 17u);

    take.begin_s = 3;  // another box began first
    for (PulseAtBoard& pulse : pair.pulses)
        pulse.time_s += 3;
    support = jointSupport(defaultActor().skeleton, suit, {pair}, {1.0, 0.5}, take, 0.6);
    EXPECT_NEAR(of("LeftArm").ranges, 0.51, 0.01);
    EXPECT_NEAR(of("LeftArm").lost_from_s.value_or(0), 3 + 5.1, 0.1);
}

TEST(JointSupport, TheRestPoseAtTheBeginningDoesNotCount) {
    Suit suit;
    suit.boards = {{"l_hand", "", "LeftHand"}};
    suit.sources = {{"s1", "", "Chest"}};
    ReportPair pair{0, 0, {}};
    for (int i = 0; i < 75; ++i)  // no range is used while the rest pose is measured
        pair.pulses.push_back(
            {0.1f * static_cast<float>(i), i < 52 ? PulseFate::kRejected : PulseFate::kUsed, 1, 1, 0});
    ReportTake take;
    take.duration_s = 7.5;
    take.rest_s = 5.2;
    const auto shareOfHand = [&] {
        const auto support = jointSupport(defaultActor().skeleton, suit, {pair}, {1.0}, take);
        return std::ranges::find(support, "LeftHand", &JointSupport::joint)->ranges;
    };
    EXPECT_NEAR(shareOfHand(), 1, 0.06);

    take.begin_s = 3;  // another box began first; the rest is on the take's clock
    take.rest_s += 3;
    for (PulseAtBoard& pulse : pair.pulses)
        pulse.time_s += 3;
    EXPECT_NEAR(shareOfHand(), 1, 0.06);

    take.rest_s = take.end_s() + 1;
    EXPECT_EQ(shareOfHand(), 0);
}

}  // namespace
}  // namespace noctule
