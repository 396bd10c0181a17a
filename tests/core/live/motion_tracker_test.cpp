// SPDX-License-Identifier: Apache-2.0
#include "core/live/motion_tracker.h"

#include <gtest/gtest.h>

#include <set>

#include "core/suit/default_suit.h"
#include "tests/support/rate.h"

namespace noctule {
namespace {

using test::kRate_hz;
using Rest = std::optional<std::pair<int64_t, int64_t>>;

std::unique_ptr<MotionTracker> makeTracker(const Rest& rest, const TrackerSettings& settings = {}) {
    const Suit suit = defaultSuit();
    return std::move(
        MotionTracker::create(suit, nominalCalibration(suit), defaultActor(), kRate_hz, rest, settings)
            .value());
}

/// A board lying still with its Y axis up, as far as counts say.
InertialReading stillReading(int board, int64_t frame) {
    InertialReading reading;
    reading.board = board;
    reading.frame = frame;
    reading.sample = static_cast<double>(frame) * kRate_hz / kInertialFramesPerSecond;
    reading.counts = {2048, 2048, 2048, 2048, 2048 + 128, 2048};
    reading.corrected_bits = 0;
    return reading;
}

RangeMeasurement rangeOf(int64_t pulse) {
    RangeMeasurement range;
    range.pulse = pulse;
    range.pulse_sample = pulse * 1200;
    range.source = static_cast<int>(pulse % 8);
    range.board = static_cast<int>(pulse % 18);
    range.distance_m = 0.5;
    range.w_s = range.w_t = 1;
    range.sigma_m = 0.001;
    return range;
}

TEST(MotionTracker, WithoutARestPoseItStartsAtTheFirstSample) {
    const auto tracker = makeTracker(std::nullopt);
    tracker->advanceTo(0);
    EXPECT_TRUE(tracker->takePoses().empty());
    for (int64_t frame = 0; frame < 14; ++frame)
        tracker->add(stillReading(2, frame));
    tracker->advanceTo(15000);
    const std::vector<TimedPose> poses = tracker->takePoses();
    ASSERT_GE(poses.size(), 13u);
    EXPECT_EQ(poses.front().time_ns, 0);
    EXPECT_NEAR(static_cast<double>(poses[1].time_ns), 1e9 / kInertialFramesPerSecond, 1);
}

TEST(MotionTracker, WaitsForTheEndOfTheRestPoseAndThenCoversIt) {
    const auto tracker = makeTracker(Rest({0, 75000}));
    for (int64_t frame = 0; frame < 105; ++frame)
        tracker->add(stillReading(2, frame));
    tracker->advanceTo(75000);
    EXPECT_TRUE(tracker->takePoses().empty());
    tracker->advanceTo(105000);
    const std::vector<TimedPose> poses = tracker->takePoses();
    ASSERT_GE(poses.size(), 97u);
    EXPECT_EQ(poses.front().time_ns, 0);
    for (const TimedPose& timed : poses)
        EXPECT_TRUE(timed.pose && isUsable(*timed.pose)) << timed.time_ns;
}

void expectEachRangeOnce(const Rest& rest, const TrackerSettings& settings) {
    const auto tracker = makeTracker(rest, settings);
    constexpr int64_t kPulses = 60;
    std::multiset<int64_t> out;
    int64_t tried = 0;
    for (int64_t pulse = 0; pulse < kPulses; ++pulse) {
        tracker->add(rangeOf(pulse));
        tracker->advanceTo(pulse * 1200);
        for (const RangeMeasurement& range : tracker->takeRanges()) {
            out.insert(range.pulse);
            tried += range.fate != RangeFate::kNotTried;
        }
    }
    tracker->advanceTo((kPulses + 2) * 1200);
    for (const RangeMeasurement& range : tracker->takeRanges()) {
        out.insert(range.pulse);
        tried += range.fate != RangeFate::kNotTried;
    }
    for (int64_t pulse = 0; pulse < kPulses; ++pulse)
        EXPECT_EQ(out.count(pulse), 1u) << "pulse " << pulse;
    const int64_t after_rest = rest ? kPulses - (rest->second + 1199) / 1200 : kPulses;
    // One that arrives before the estimator's first step comes out untried.
    EXPECT_LE(tried, settings.sensors.distances ? after_rest : 0);
    EXPECT_GE(tried, settings.sensors.distances ? after_rest - 1 : 0);
}

TEST(MotionTracker, EveryRangeComesOutOnce) {
    for (const std::string estimator : {kManifoldEstimator, kPaperEstimator})
        for (const Rest& rest : {Rest(), Rest({0, 30001}), Rest({0, 36000})}) {
            SCOPED_TRACE(estimator + (rest ? ", rest" : ", no rest"));
            TrackerSettings settings;
            settings.estimator = estimator;
            expectEachRangeOnce(rest, settings);
            settings.sensors.distances = false;
            expectEachRangeOnce(rest, settings);
        }
}

TEST(MotionTracker, RefusesASuitOnASegmentThatTheActorLacks) {
    Suit suit = defaultSuit();
    suit.boards[4].segment = "LeftTentacle";
    const auto refused = MotionTracker::create(suit, nominalCalibration(suit), defaultActor(), kRate_hz,
                                               std::nullopt, TrackerSettings{});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("LeftTentacle"), std::string::npos) << refused.error().text();
    EXPECT_NE(refused.error().message.find(suit.boards[4].id), std::string::npos) << refused.error().text();
}

TEST(MotionTracker, RefusesUnknownEstimatorsAndParameters) {
    const Suit suit = defaultSuit();
    const auto refusal = [&](const TrackerSettings& settings) {
        const auto made = MotionTracker::create(suit, nominalCalibration(suit), defaultActor(), kRate_hz,
                                                std::nullopt, settings);
        EXPECT_FALSE(made);
        EXPECT_EQ(made.error().kind, ErrorKind::kUsage);
        return made.error().text();
    };
    TrackerSettings settings;
    settings.estimator = "manifolt";
    EXPECT_NE(refusal(settings).find("Did you mean manifold?"), std::string::npos);
    settings.estimator = kManifoldEstimator;
    settings.parameters = {{"range.gates", 5}};
    EXPECT_NE(refusal(settings).find("Did you mean range.gate?"), std::string::npos);
    settings.parameters = {{"range.gate", 0.5}};
    EXPECT_NE(refusal(settings).find("from 1 to 100"), std::string::npos);
    settings.parameters = {{"steps_per_frame", 1.5}};
    EXPECT_NE(refusal(settings).find("whole number"), std::string::npos);
}

}  // namespace
}  // namespace noctule
