// SPDX-License-Identifier: Apache-2.0
#include "core/live/inertial_calibrator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/inertial/step_table.h"
#include "tests/support/rate.h"

namespace noctule {
namespace {

using test::kRate_hz;

Suit oneBoard() {
    Suit suit;
    suit.name = "one";
    suit.boards.resize(1);
    suit.boards[0].id = "board";
    return suit;
}

Calibration misaligned() {
    Calibration calibration = nominalCalibration(oneBoard());
    AxisCalibration& gyro = calibration.boards[0].gyro;
    gyro.zero_counts = {2011, 2075, 2040};
    gyro.matrix << 8.5e-3, 1.4e-4, -9e-5, -1.1e-4, 8.7e-3, 2e-4, 6e-5, -1.7e-4, 8.4e-3;
    AxisCalibration& accel = calibration.boards[0].accel;
    accel.zero_counts = {2100, 1990, 2051};
    accel.matrix << 0.077, -0.001, 0.0008, 0.0012, 0.0755, -0.0015, -0.0007, 0.0009, 0.078;
    return calibration;
}

InertialReading readingOf(const Vector3d& gyro_counts, const Vector3d& accel_counts, int64_t frame = 0) {
    InertialReading reading;
    reading.frame = frame;
    reading.sample = 300 + static_cast<double>(frame) * kRate_hz / kInertialFramesPerSecond;
    for (size_t i = 0; i < 3; ++i) {
        reading.counts[i] = gyro_counts[static_cast<Eigen::Index>(i)];
        reading.counts[3 + i] = accel_counts[static_cast<Eigen::Index>(i)];
    }
    return reading;
}

InertialReading allAt(double counts, int64_t frame) {
    return readingOf(Vector3d::Constant(counts), Vector3d::Constant(counts), frame);
}

TEST(InertialCalibrator, MisalignedTriadWithAnAxisMissingStillGivesExactEquations) {
    const Calibration calibration = misaligned();
    const Vector3d rate(1.2, -3.4, 0.7), force(-4, 9.5, 2.2);
    const auto counts = [](const AxisCalibration& axes, const Vector3d& value) -> Vector3d {
        return axes.zero_counts + axes.matrix.inverse() * value;
    };
    for (size_t missing = 0; missing < 3; ++missing) {
        InertialCalibrator calibrator(oneBoard(), calibration, kRate_hz);
        InertialReading reading =
            readingOf(counts(calibration.boards[0].gyro, rate), counts(calibration.boards[0].accel, force));
        reading.counts[missing].reset();
        reading.counts[3 + missing].reset();
        const InertialMeasurement measurement = calibrator.convert(reading);
        EXPECT_DOUBLE_EQ(measurement.time_s, 0.002);
        for (const auto& [triad, truth] :
             {std::pair{&measurement.gyro, rate}, std::pair{&measurement.accel, force}}) {
            ASSERT_EQ(triad->count, 2);
            for (size_t i = 0; i < 2; ++i) {
                const AxisReading& axis = triad->axes[i];
                EXPECT_NEAR(axis.sensitive_axis_board.norm(), 1, 1e-12);
                EXPECT_NEAR(axis.sensitive_axis_board.dot(truth), axis.value, 1e-10);
                EXPECT_GT(axis.sigma, 0);
            }
        }
    }
}

TEST(InertialCalibrator, ClippedReadingsSaySoAndAreCounted) {
    InertialCalibrator calibrator(oneBoard(), nominalCalibration(oneBoard()), kRate_hz);
    const InertialMeasurement whole = calibrator.convert(readingOf({2048, 2048, 2048}, {2048, 2048, 2048}));
    EXPECT_EQ(whole.gyro.inRange().count, 3);
    const InertialMeasurement clipped = calibrator.convert(readingOf({0, 2048, 4095}, {2048, 4095, 2048}, 1));
    ASSERT_EQ(clipped.gyro.count, 3);
    EXPECT_EQ(clipped.gyro.axes[0].beyond, -1);
    EXPECT_NEAR(clipped.gyro.axes[0].value, -17.5, 0.01);
    EXPECT_EQ(clipped.gyro.axes[1].beyond, 0);
    EXPECT_EQ(clipped.gyro.axes[2].beyond, 1);
    EXPECT_GT(clipped.gyro.axes[2].sigma, 1) << "the truth may lie far beyond";
    EXPECT_EQ(clipped.gyro.inRange().count, 1);
    EXPECT_EQ(clipped.accel.inRange().count, 2);
    EXPECT_EQ(calibrator.clippedReadings(0), 3);
}

TEST(InertialCalibrator, NearTheEndALargeStepIsSuspectAndASmallOneIsNot) {
    InertialCalibrator calibrator(oneBoard(), nominalCalibration(oneBoard()), kRate_hz);
    calibrator.convert(allAt(3000, 0));
    EXPECT_EQ(calibrator.convert(allAt(4061, 1)).gyro.count, 0) << "may stand for a clipped value";
    EXPECT_EQ(calibrator.convert(allAt(4063, 2)).gyro.count, 3);
    EXPECT_EQ(calibrator.clippedReadings(0), 0);
}

TEST(InertialCalibrator, SigmaGrowsWithTheStepAndRemembersTheOneBefore) {
    const SensorNoise noise{0.002, 0.02};
    const double rad_per_s_per_count = 17.5 / 2048;
    double last_sigma = 0;
    for (const double step : {0, 6, 37, 178, 849}) {
        InertialCalibrator calibrator(oneBoard(), nominalCalibration(oneBoard()), kRate_hz, noise);
        calibrator.convert(allAt(1500, 0));
        const double sigma = calibrator.convert(allAt(1500 + step, 1)).gyro.axes[0].sigma;
        const double rounding = codecRoundingSigmaCounts(step);
        // Differences of white noise at 13 of 140 Hz: |1 - exp(i 2 pi 13 / 140)| / sqrt(2) of their
        // deviation.
        constexpr double kSlow = 0.4067;
        const double both = rad_per_s_per_count * std::hypot(rounding, codecRoundingSigmaCounts(0));
        EXPECT_NEAR(sigma, std::hypot(noise.gyro_rad_per_s, kSlow * both), 1e-4 * sigma);
        EXPECT_GE(sigma, last_sigma) << step;
        last_sigma = sigma;
        // What this frame rounded away the next one pays back.
        const double after = calibrator.convert(allAt(1500 + step, 2)).gyro.axes[0].sigma;
        EXPECT_NEAR(after, sigma, 1e-12);
        const double settled = calibrator.convert(allAt(1500 + step, 3)).gyro.axes[0].sigma;
        EXPECT_LE(settled, after);
    }
    EXPECT_GT(last_sigma, 10 * noise.gyro_rad_per_s);
}

TEST(InertialCalibrator, ValuesOfOtherSensorsPassAsTheyAre) {
    Suit suit;
    suit.boards.resize(1);
    suit.boards[0].id = "hips";
    Calibration calibration;
    calibration.boards.resize(1);
    calibration.boards[0].id = "hips";
    calibration.boards[0].gyro.zero_counts.setZero();
    calibration.boards[0].accel.zero_counts.setZero();
    InertialCalibrator calibrator(suit, calibration, 150000);
    InertialReading reading;
    const double values[6] = {-0.5, 0.0, 3.25, -9.8, 0.01, -200.0};
    std::copy(values, values + 6, reading.counts.begin());
    const InertialMeasurement measurement = calibrator.convert(reading);
    ASSERT_EQ(measurement.gyro.count, 3);
    ASSERT_EQ(measurement.accel.count, 3);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(measurement.gyro.axes[i].value, values[i]);
        EXPECT_EQ(measurement.accel.axes[i].value, values[3 + i]);
    }
    EXPECT_EQ(calibrator.clippedReadings(0), 0);
}

}  // namespace
}  // namespace noctule
