// SPDX-License-Identifier: Apache-2.0
// The readings level against the truth and against the signal level.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "core/acoustics/range_finder.h"
#include "core/inertial/stream_receiver.h"
#include "core/simulation/pulse_readings.h"
#include "core/simulation/signal_sampler.h"
#include "core/simulation/simulate.h"
#include "tests/core/simulation/simulated_body.h"

namespace noctule::simulation {
namespace {

Stage makeStage(const Scenario& scenario, double seconds, uint64_t seed = 1) {
    return prepareStage({.clip = madeMotion(seconds),
                         .actor = std::nullopt,
                         .suit = defaultSuit(),
                         .scenario = scenario,
                         .rest_seconds = 1.0,
                         .duration_s = 0,
                         .seed = seed})
        .value();
}

RangeFinder finderOf(const Stage& stage) {
    const PulseSchedule schedule = stage.scenario.schedule();
    RangeFinder finder = RangeFinder::create(stage.suit, stage.calibration,
                                             {double(stage.scenario.sample_rate_hz),
                                              schedule.interval_samples, schedule.drive_hz, schedule.cycles},
                                             Detector::kInflection)
                             .value();
    finder.soundSpeed().add({0, stage.truth.air.temperature_c, stage.truth.air.humidity_percent});
    return finder;
}

double trueDistance(const Stage& stage, const RangeMeasurement& range) {
    const double emission_s = double(range.pulse_sample) / stage.scenario.sample_rate_hz +
                              stage.truth.sound.sources[range.source].start_delay_s;
    return directFlight(*stage.world, range.source, range.board, emission_s,
                        stage.truth.air.speedOfSound_m_per_s())
        .distance_m;
}

/// Errors of all ranges, in metres.
struct RangeErrors {
    std::vector<double> line_of_sight;  ///< with full strength and continuity
    double heard = 0;                   ///< rows in all
    double median() const { return at(0.5); }
    double spread() const { return (at(0.84) - at(0.16)) / 2; }
    double outliers() const {
        return double(std::count_if(line_of_sight.begin(), line_of_sight.end(),
                                    [](double e) { return std::abs(e) > 0.015; })) /
               double(line_of_sight.size());
    }
    double at(double quantile) const {
        std::vector<double> sorted = line_of_sight;
        std::sort(sorted.begin(), sorted.end());
        return sorted[size_t(quantile * double(sorted.size() - 1))];
    }
    void add(const Stage& stage, const RangeMeasurement& range) {
        ++heard;
        if (range.w_s * range.w_t >= 1)
            line_of_sight.push_back(range.distance_m - trueDistance(stage, range));
    }
};

RangeErrors rangesFromReadings(const Stage& stage) {
    RangeErrors errors;
    RangeFinder finder = finderOf(stage);
    PulseReadings readings(*stage.world, stage.scenario, stage.truth);
    std::vector<PulseDetection> detections;
    const PulseSchedule schedule = stage.scenario.schedule();
    for (int64_t k = 0; (k + 2) * schedule.interval_samples < stage.sampleCount(); ++k) {
        readings.hear(schedule.pulse(k, stage.world->sourceCount()), detections);
        for (const PulseDetection& detection : detections)
            if (const auto range = finder.process(detection))
                errors.add(stage, *range);
    }
    return errors;
}

RangeErrors rangesFromSignal(const Stage& stage) {
    RangeErrors errors;
    RangeFinder finder = finderOf(stage);
    const PulseSchedule schedule = stage.scenario.schedule();
    PulseReceiver receiver =
        PulseReceiver::create(Detector::kInflection,
                              {double(stage.scenario.sample_rate_hz), schedule.interval_samples,
                               schedule.drive_hz, schedule.cycles},
                              stage.world->boardCount())
            .value();
    SignalSampler sampler(*stage.world, stage.scenario, stage.truth);
    std::vector<PulseDetection> detections;
    for (int64_t k = 0; (k + 1) * schedule.interval_samples < stage.sampleCount(); ++k) {
        receiver.pushBlock(k * schedule.interval_samples, sampler.next(schedule.interval_samples));
        receiver.pushPulse(schedule.pulse(k, stage.world->sourceCount()));
        detections.clear();
        receiver.advance((k + 1) * schedule.interval_samples, detections);
        for (const PulseDetection& detection : detections)
            if (const auto range = finder.process(detection))
                errors.add(stage, *range);
    }
    return errors;
}

TEST(Readings, IdealInertiaIsTheTruth) {
    const Stage stage = makeStage(Scenario::ideal(), 3);
    for (int b = 0; b < stage.world->boardCount(); ++b) {
        BoardReadings readings(*stage.world, b, stage.truth.inertia[b], stage.scenario, stage.truth.seed);
        for (int64_t frame = 0; frame < 400; ++frame) {
            const InertialReading reading = readings.next(frame);
            const BoardMotion truth =
                stage.world->boardMotion(b, reading.sample / stage.scenario.sample_rate_hz);
            const Vector3d gyro(*reading.counts[0], *reading.counts[1], *reading.counts[2]);
            const Vector3d accel(*reading.counts[3], *reading.counts[4], *reading.counts[5]);
            EXPECT_LT((stage.calibration.boards[b].gyro.apply(gyro) - truth.gyro_rad_per_s).norm(), 1e-9);
            EXPECT_LT((stage.calibration.boards[b].accel.apply(accel) - truth.accel_m_per_s2).norm(), 1e-8);
        }
    }
}

TEST(Readings, IdealRangesInLineOfSightAreTheTruth) {
    const RangeErrors errors = rangesFromReadings(makeStage(Scenario::ideal(), 3));
    ASSERT_GT(errors.line_of_sight.size(), 1000u);
    EXPECT_LT(std::abs(errors.at(0)), 1e-6);
    EXPECT_LT(std::abs(errors.at(1)), 1e-6);
}

TEST(Readings, InertialNoiseAndBiasHaveTheScenariosSize) {
    Scenario scenario = Scenario::nominal();
    scenario.codec = false;
    scenario.gyro_bias_walk_rad_per_s_per_sqrt_s = 0;
    scenario.gyro_matrix_error = scenario.accel_matrix_error = 0;
    double noise = 0, accel_noise = 0, bias = 0;
    int samples = 0, chips = 0;
    for (uint64_t seed = 1; seed <= 4; ++seed) {
        const Stage stage = makeStage(scenario, 3, seed);
        for (int b = 0; b < stage.world->boardCount(); ++b) {
            BoardReadings readings(*stage.world, b, stage.truth.inertia[b], scenario, seed);
            Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero(), accel_squares = Vector3d::Zero();
            for (int64_t frame = 0; frame < 400; ++frame, ++samples) {
                const InertialReading r = readings.next(frame);
                const BoardMotion truth = stage.world->boardMotion(b, r.sample / scenario.sample_rate_hz);
                const Vector3d error =
                    stage.calibration.boards[b].gyro.apply({*r.counts[0], *r.counts[1], *r.counts[2]}) -
                    truth.gyro_rad_per_s;
                const Vector3d accel_error =
                    stage.calibration.boards[b].accel.apply({*r.counts[3], *r.counts[4], *r.counts[5]}) -
                    truth.accel_m_per_s2 - stage.truth.inertia[b].accel.bias;
                sum += error;
                squares += error.cwiseAbs2();
                accel_squares += accel_error.cwiseAbs2();
            }
            const Vector3d mean = sum / 400;
            bias += mean.squaredNorm();
            noise += (squares - 400 * mean.cwiseAbs2()).sum();
            accel_noise += accel_squares.sum();
            ++chips;
        }
    }
    EXPECT_NEAR(std::sqrt(noise / (3 * samples)), 0.002, 0.00003);
    EXPECT_NEAR(std::sqrt(accel_noise / (3 * samples)), 0.02, 0.0003);
    EXPECT_NEAR(std::sqrt(bias / (3 * chips)), 0.005, 0.0007);  // 216 draws
}

TEST(Levels, InertialRowsAreTheSame) {
    const Stage stage = makeStage(Scenario::nominal(), 2);
    SignalSampler sampler(*stage.world, stage.scenario, stage.truth);
    StreamReceiver receiver(3, stage.scenario.sample_rate_hz, false);
    const int boards = stage.world->boardCount();
    for (int64_t first = 0; first + 6000 <= stage.sampleCount(); first += 6000)
        receiver.push(first, sampler.next(6000), 3, boards);
    receiver.finish();
    std::map<int64_t, InertialReading> decoded;
    for (const InertialReading& reading : receiver.takeReadings())
        decoded[reading.frame] = reading;
    BoardReadings readings(*stage.world, 3, stage.truth.inertia[3], stage.scenario, stage.truth.seed);
    int compared = 0;
    for (int64_t frame = 0; frame < 400; ++frame) {
        const InertialReading expected = readings.next(frame);
        const auto found = decoded.find(frame);
        if (found == decoded.end() || !found->second.corrected_bits)
            continue;
        EXPECT_NEAR(found->second.sample, expected.sample, 2.5);  // the receiver finds s0 to two samples
        for (size_t axis = 0; axis < 6; ++axis)
            if (found->second.counts[axis] && expected.counts[axis]) {
                EXPECT_EQ(*found->second.counts[axis], *expected.counts[axis]) << frame;
                ++compared;
            }
    }
    EXPECT_GT(compared, 1200);
}

TEST(Levels, RangeErrorsAgree) {
    for (uint64_t seed = 1; seed <= 2; ++seed) {
        SCOPED_TRACE(seed);
        const Stage stage = makeStage(Scenario::nominal(), 6, seed);
        const RangeErrors signal = rangesFromSignal(stage), readings = rangesFromReadings(stage);
        for (const auto& [name, e] : {std::pair{"signal  ", &signal}, std::pair{"readings", &readings}})
            std::printf(
                "%s: %.0f rows, %zu at full confidence, median %.2f mm, spread %.2f mm, outliers %.2f %%\n",
                name, e->heard, e->line_of_sight.size(), 1000 * e->median(), 1000 * e->spread(),
                100 * e->outliers());
        EXPECT_NEAR(readings.heard / signal.heard, 1, 0.03);
        EXPECT_NEAR(double(readings.line_of_sight.size()) / double(signal.line_of_sight.size()), 1, 0.03);
        EXPECT_NEAR(readings.median(), signal.median(), 0.00025);
        EXPECT_NEAR(readings.spread() / signal.spread(), 1, 0.25);
        EXPECT_LT(readings.outliers(), 1.5 * signal.outliers());
        EXPECT_GT(readings.outliers(), signal.outliers() / 1.5);
    }
}

TEST(WriteTake, CancelLeavesNoFile) {
    const Stage stage = makeStage(Scenario::nominal(), 2);
    const std::string path = ::testing::TempDir() + "cancelled_take.noctule";
    CancelFlag cancel;
    cancel.cancel();
    TakeRequest request;
    request.out_path = path;
    request.created_utc = "2026-01-01T00:00:00Z";
    const auto written = writeTake(stage, request, {nullptr, &cancel});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::kCancelled);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(WriteTake, BothLevelsAreWrittenAndNeverOver) {
    const Stage stage = makeStage(Scenario::nominal(), 2);
    for (const Level level : {Level::kSignal, Level::kReadings}) {
        const std::string path = ::testing::TempDir() + (level == Level::kSignal ? "s.noctule" : "r.noctule");
        std::filesystem::remove(path);
        TakeRequest request;
        request.out_path = path;
        request.level = level;
        request.name = "made";
        request.created_utc = "2026-01-01T00:00:00Z";
        request.software = "noctule";
        const auto written = writeTake(stage, request, {});
        ASSERT_TRUE(written) << written.error().text();
        EXPECT_TRUE(std::filesystem::exists(path));
        EXPECT_GT(written->pulses, 360);
        EXPECT_EQ(level == Level::kReadings, written->range_rows > 0 && written->inertial_rows > 0);
        EXPECT_FALSE(writeTake(stage, request, {}));
        std::filesystem::remove(path);
    }
}

}  // namespace
}  // namespace noctule::simulation
