// SPDX-License-Identifier: Apache-2.0
// Poses must depend on the samples alone, never on how they arrived.
#include "core/live/live_pipeline.h"

#include <algorithm>
#include <cstring>
#include <random>

#include "tests/core/live/worn_tiny_take.h"

namespace noctule {
namespace {

using test::WornTinyTake;

struct Outcome {
    std::vector<InertialReading> readings;
    std::vector<RangeMeasurement> ranges;
    std::vector<TimedPose> poses;

    void takeFrom(LivePipeline& pipeline) {
        std::ranges::move(pipeline.takeReadings(), std::back_inserter(readings));
        std::ranges::move(pipeline.takeRanges(), std::back_inserter(ranges));
        std::ranges::move(pipeline.takePoses(), std::back_inserter(poses));
    }
};

/// Samples [first, end) that reach the computer.
using Stretch = std::pair<int64_t, int64_t>;

struct Delivery {
    std::vector<Stretch> stretches;
    std::vector<std::tuple<int64_t, int64_t, std::optional<int>>> marked_missing;
    bool log_at_once = true;  ///< pulses and temperatures of the whole take are known at its beginning
};

/// `next_size` says how many samples the next block holds.
template <class NextSize>
Outcome process(const WornTinyTake& worn, const Delivery& delivery, NextSize next_size) {
    PipelineSettings settings{{worn.train}, {}, worn.rest};
    settings.tracker.root_given = true;
    auto pipeline =
        std::move(LivePipeline::create(worn.suit, worn.calibration, worn.actor, settings).value());
    size_t next_pulse = 0, next_status = 0;
    const auto pushLog = [&](int64_t until) {
        for (; next_pulse < worn.pulses.size() && worn.pulses[next_pulse].sample < until; ++next_pulse)
            pipeline->pushPulse(worn.pulses[next_pulse]);
        for (; next_status < worn.statuses.size() && worn.statuses[next_status].sample < until; ++next_status)
            pipeline->pushStatus(worn.statuses[next_status]);
    };
    if (delivery.log_at_once)
        pushLog(worn.sampleCount());
    for (const RootMeasurement& root : worn.roots)
        pipeline->pushRoot(root);
    for (const auto& [first, count, board] : delivery.marked_missing)
        pipeline->pushGap(first, count, board);
    Outcome outcome;
    for (const auto& [begin, end] : delivery.stretches)
        for (int64_t at = begin; at < end;) {
            const int64_t next = std::min<int64_t>(end, at + next_size());
            pushLog(next);
            pipeline->pushBlock(at, worn.samples(at, next));
            outcome.takeFrom(*pipeline);
            at = next;
        }
    pipeline->finish();
    outcome.takeFrom(*pipeline);
    return outcome;
}

/// Bit for bit, so that -0 or the last bit of a sum would show.
bool sameBits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void expectSame(const InertialReading& a, const InertialReading& b) {
    EXPECT_EQ(a.board, b.board);
    EXPECT_EQ(a.frame, b.frame);
    EXPECT_TRUE(sameBits(a.sample, b.sample));
    EXPECT_EQ(a.counts, b.counts);
    EXPECT_EQ(a.corrected_bits, b.corrected_bits);
}

void expectSame(const RangeMeasurement& a, const RangeMeasurement& b) {
    EXPECT_EQ(a.pulse, b.pulse);
    EXPECT_EQ(a.board, b.board);
    EXPECT_EQ(a.fate, b.fate);
    for (double RangeMeasurement::*member :
         {&RangeMeasurement::arrival_sample, &RangeMeasurement::distance_m, &RangeMeasurement::w_s,
          &RangeMeasurement::w_t, &RangeMeasurement::w_a, &RangeMeasurement::sigma_m,
          &RangeMeasurement::innovation_m})
        EXPECT_TRUE(sameBits(a.*member, b.*member)) << "pulse " << a.pulse << " board " << a.board;
}

void expectSame(const TimedPose& a, const TimedPose& b) {
    EXPECT_EQ(a.time_ns, b.time_ns);
    ASSERT_TRUE(a.pose && b.pose);
    EXPECT_EQ(a.pose->p_world_root, b.pose->p_world_root) << a.time_ns;
    for (size_t j = 0; j < a.pose->q_parent_joint.size(); ++j)
        EXPECT_EQ(a.pose->q_parent_joint[j].coeffs(), b.pose->q_parent_joint[j].coeffs()) << a.time_ns;
    EXPECT_EQ(a.sigma_rad, b.sigma_rad) << a.time_ns;
}

template <class Row>
void expectSame(const std::vector<Row>& a, const std::vector<Row>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size() && !testing::Test::HasFailure(); ++i)
        expectSame(a[i], b[i]);
}

void expectSame(const Outcome& a, const Outcome& b) {
    expectSame(a.readings, b.readings);
    expectSame(a.ranges, b.ranges);
    expectSame(a.poses, b.poses);
}

void expectSameForRandomSplits(const WornTinyTake& worn, const Delivery& delivery) {
    const Outcome expected = process(worn, delivery, [] { return 6000; });
    ASSERT_GT(expected.poses.size(), 250u);
    ASSERT_GT(expected.ranges.size(), 100u);
    ASSERT_GT(expected.readings.size(), 300u);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int largest = seed == 1 ? 100 : 7000;
        expectSame(expected, process(worn, delivery,
                                     [&] { return std::uniform_int_distribution<int>(1, largest)(random); }));
    }
}

TEST(LivePipeline, PosesDoNotDependOnHowSamplesArrive) {
    const WornTinyTake worn = test::wornTinyTake();
    expectSameForRandomSplits(worn, {{{0, worn.sampleCount()}}, {}, true});
}

TEST(LivePipeline, NorDoTheyAroundGaps) {
    const WornTinyTake worn = test::wornTinyTake();
    expectSameForRandomSplits(worn, {{{0, 100001}, {104857, 200000}, {200150, worn.sampleCount()}},
                                     {{50000, 20, std::nullopt}, {150000, 4000, 1}, {260001, 1, 0}},
                                     true});
}

TEST(LivePipeline, ARecordingKnowsNoMoreThanTheLiveRunDid) {
    WornTinyTake worn = test::wornTinyTake();
    worn.statuses = {{0, 20, 40}, {140000, 30, 40}, {140700, 10, 40}};
    const Delivery recorded{{{0, worn.sampleCount()}}, {}, true}, live{{{0, worn.sampleCount()}}, {}, false};
    const Outcome expected = process(worn, recorded, [] { return 6000; });
    expectSame(expected, process(worn, live, [] { return 300; }));
    expectSame(expected, process(worn, live, [] { return 3000; }));
}

TEST(LivePipeline, LosesNoRangeAndNoPose) {
    const WornTinyTake worn = test::wornTinyTake();
    const Outcome outcome = process(worn, {{{0, worn.sampleCount()}}, {}, true}, [] { return 6000; });
    std::vector<std::pair<int64_t, int>> keys;
    for (const RangeMeasurement& range : outcome.ranges)
        keys.emplace_back(range.pulse, range.board);
    std::ranges::sort(keys);
    EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end()) << "a range came out twice";
    for (size_t i = 1; i < outcome.poses.size(); ++i)
        EXPECT_NEAR(static_cast<double>(outcome.poses[i].time_ns - outcome.poses[i - 1].time_ns),
                    1e9 / kInertialFramesPerSecond, 1);
    EXPECT_EQ(outcome.poses.front().time_ns, 0);
    EXPECT_GT(outcome.poses.back().time_ns, 2'000'000'000);
}

}  // namespace
}  // namespace noctule
