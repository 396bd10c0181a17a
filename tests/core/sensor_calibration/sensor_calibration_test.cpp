// SPDX-License-Identifier: Apache-2.0
// Simulated sensors with errors that the fits do not know, and BROAD's recordings (../shared/data), without
// which that test skips.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/import/import_format.h"
#include "core/math/rotation.h"
#include "core/sensor_calibration/hand_calibration.h"
#include "core/sensor_calibration/magnetometer_fit.h"
#include "tests/support/files.h"

namespace noctule::test {
namespace {

constexpr double kEarth_ut = 48;

double angleOf(const Vector3d& a, const Vector3d& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

class Simulator {
public:
    explicit Simulator(unsigned seed) : random_(seed) {}
    Vector3d noise(double sigma) {
        return sigma * Vector3d{normal_(random_), normal_(random_), normal_(random_)};
    }
    Vector3d direction() { return noise(1).normalized(); }
    double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }

private:
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
};

struct SimulatedField {
    std::vector<Vector3d> truth, readings;
    Vector3d hard;
    Matrix3d soft;
};

/// A share of the readings is taken near a magnet that the fit does not know. `reach` below 1: the board is
/// turned about its z axis and tilted by that much at most.
SimulatedField turnedBoard(unsigned seed, double disturbed_share, double reach) {
    Simulator simulate(seed);
    SimulatedField field;
    field.hard = simulate.noise(25);
    const Matrix3d part =
        (Matrix3d() << simulate.noise(0.06), simulate.noise(0.06), simulate.noise(0.06)).finished();
    field.soft = Matrix3d::Identity() + 0.5 * (part + part.transpose());
    for (int i = 0; i < 3000; ++i) {
        Vector3d direction = simulate.direction();
        if (reach < 1) {
            const double turn = 2 * std::numbers::pi * simulate.uniform();
            direction = Vector3d(std::cos(turn), std::sin(turn), reach * (2 * simulate.uniform() - 1));
        }
        const Vector3d truth = kEarth_ut * direction.normalized();
        Vector3d reading = field.soft * truth + field.hard + simulate.noise(0.5);
        if (simulate.uniform() < disturbed_share)
            reading += simulate.noise(12);
        field.truth.push_back(truth);
        field.readings.push_back(reading);
    }
    return field;
}

TEST(MagnetometerFit, FindsHardAndSoftIronBesideAnUnknownMagnet) {
    for (unsigned seed = 1; seed <= 10; ++seed)
        for (const double disturbed : {0.0, 0.1}) {
            const SimulatedField field = turnedBoard(seed, disturbed, 1);
            const MagnetometerFit fit = fitMagnetometer(field.readings, kEarth_ut);
            ASSERT_TRUE(fit.problem.empty()) << seed << ": " << fit.problem;
            EXPECT_LT((fit.ellipsoid.zero - field.hard).norm(), disturbed > 0 ? 1.0 : 0.3) << seed;
            double worst = 0;
            for (size_t i = 0; i < field.truth.size(); ++i) {
                const Vector3d clean = field.soft * field.truth[i] + field.hard;
                worst = std::max(
                    worst, angleOf(fit.ellipsoid.matrix * (clean - fit.ellipsoid.zero), field.truth[i]));
            }
            EXPECT_LT(worst, disturbed > 0 ? 2.0 : 0.6) << seed;
            EXPECT_EQ(fit.coverage.covered, 26);
            EXPECT_LT(fit.after_percent, fit.before_percent);
        }
}

TEST(MagnetometerFit, TheSigmaOfTheZeroIsHonest) {
    double ratio = 0;
    constexpr int kRuns = 40;
    for (unsigned seed = 100; seed < 100 + kRuns; ++seed) {
        const SimulatedField field = turnedBoard(seed, 0, 1);
        const MagnetometerFit fit = fitMagnetometer(field.readings, kEarth_ut);
        ratio += (fit.ellipsoid.zero - field.hard).cwiseQuotient(fit.ellipsoid.sigma_zero).squaredNorm() /
                 (3 * kRuns);
    }
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 2.0);
}

TEST(MagnetometerFit, TooFewDirectionsAreRefusedByName) {
    const SimulatedField flat = turnedBoard(3, 0, 0.05);
    const MagnetometerFit fit = fitMagnetometer(flat.readings, kEarth_ut);
    EXPECT_FALSE(fit.problem.empty());
    EXPECT_NE(fit.remedy.find("+z"), std::string::npos) << fit.remedy;
    EXPECT_NE(fit.remedy.find("-z"), std::string::npos) << fit.remedy;
    EXPECT_FALSE(fitMagnetometer({}, kEarth_ut).problem.empty());
    EXPECT_FALSE(
        fitMagnetometer(std::vector<Vector3d>(1000, Vector3d(20, 0, -40)), kEarth_ut).problem.empty());
}

TEST(MagnetometerFit, BroadsFieldBecomesMoreConstant) {
    const std::string path =
        NOCTULE_SOURCE_DIR "/../shared/data/imu/broad/02_undisturbed_slow_rotation_B.mat";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "needs ../shared/data/imu";
    const auto read = readImport(*findImportFormat("mat"), {{path, readBytes(path)}}, {}, {});
    ASSERT_TRUE(read) << read.error().text();
    const MagnetometerFit fit = fitMagnetometer(read->sensors[0].samples.mag, {});
    ASSERT_TRUE(fit.problem.empty()) << fit.problem << ". " << fit.remedy;
    EXPECT_LT(fit.after_percent, fit.before_percent);
    EXPECT_LT(fit.after_percent, 3);
    EXPECT_GT(fit.strength_ut, 35);
    EXPECT_LT(fit.strength_ut, 60);
}

TEST(FieldCheck, SaysWhenTheFieldIsBent) {
    Simulator simulate(5);
    ImuSamples samples;
    samples.rate_hz = 100;
    for (int i = 0; i < 3000; ++i) {
        const Vector3d bend = i >= 1000 && i < 1500 ? Vector3d(0, 10, 0) : Vector3d::Zero();
        samples.gyro_rad_per_s.push_back(simulate.noise(0.01));
        samples.accel_m_per_s2.push_back(Vector3d(0, kStandardGravity_m_per_s2, 0) + simulate.noise(0.05));
        samples.mag.push_back(Vector3d(0, -44, 20) + bend + simulate.noise(0.5));
    }
    const FieldCheck check = checkField(samples);
    EXPECT_NEAR(check.dip_deg, degrees(std::atan2(44., 20.)), 0.5);
    ASSERT_EQ(check.stretches.size(), 1u);
    EXPECT_NEAR(check.stretches[0].from_s, 10, 0.51);
    EXPECT_NEAR(check.stretches[0].to_s, 15, 0.51);
    EXPECT_NEAR(check.stretches[0].dip_off_deg, degrees(std::atan2(34., 20.) - std::atan2(44., 20.)), 1);
    EXPECT_NEAR(check.bent_percent, 100. / 6, 1);
}

/// A sensor laid down in `positions` directions for 2 s each, turned in between.
struct HandTake {
    ImuSamples samples;
    Vector3d accel_zero, gyro_zero;
    Matrix3d accel_matrix, gyro_matrix;  ///< of the readings: reading = matrix^-1 value + zero
};

HandTake layDown(unsigned seed, int positions, bool about_all_axes = true) {
    Simulator simulate(seed);
    HandTake take;
    take.samples.rate_hz = 100;
    take.accel_zero = simulate.noise(0.2);
    take.gyro_zero = simulate.noise(0.02);
    take.accel_matrix = Matrix3d::Identity();
    take.gyro_matrix = Matrix3d::Identity();
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            if (c >= r)
                take.accel_matrix(r, c) += simulate.noise(0.015).x();
            take.gyro_matrix(r, c) += simulate.noise(0.02).x();
        }
    const Matrix3d accel_inverse = take.accel_matrix.inverse(), gyro_inverse = take.gyro_matrix.inverse();
    Quaterniond q = Quaterniond::Identity();  // world from sensor
    const auto row = [&](const Vector3d& rate, double shake) {
        const Vector3d up = q.conjugate() * Vector3d(0, kStandardGravity_m_per_s2, 0) + simulate.noise(shake);
        take.samples.accel_m_per_s2.push_back(accel_inverse * up + take.accel_zero + simulate.noise(0.02));
        take.samples.gyro_rad_per_s.push_back(gyro_inverse * rate + take.gyro_zero + simulate.noise(0.002));
        q = (q * expQuaternion(Vector3d(rate / 100))).normalized();
    };
    for (int p = 0; p < positions; ++p) {
        for (int i = 0; i < 200; ++i)
            row(Vector3d::Zero(), 0);
        const Vector3d axis = about_all_axes ? simulate.direction() : Vector3d::UnitX();
        const double angle = 1 + 1.5 * simulate.uniform();
        for (int i = 0; i < 150; ++i)
            row(angle / 1.5 * (1 - std::cos(2 * std::numbers::pi * i / 150)) * axis, 0.5);
    }
    for (int i = 0; i < 200; ++i)
        row(Vector3d::Zero(), 0);
    return take;
}

TEST(HandCalibration, FindsScalesAxesAndZeros) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const HandTake take = layDown(seed, 40);
        const HandFit fit = calibrateByHand(take.samples, kStandardGravity_m_per_s2);
        ASSERT_TRUE(fit.problem.empty()) << seed << ": " << fit.problem;
        EXPECT_LT((fit.accel.zero - take.accel_zero).norm(), 0.03) << seed;
        EXPECT_LT((fit.accel.matrix - take.accel_matrix).norm(), 0.006) << seed;
        EXPECT_LT((fit.gyro.zero - take.gyro_zero).norm(), 0.0005) << seed;
        EXPECT_LT((fit.gyro.matrix - take.gyro_matrix).norm(), 0.01) << seed;
        EXPECT_LT(fit.gyro.residual_deg, 0.6) << seed;
        EXPECT_GT(fit.gyro.before_deg, 2 * fit.gyro.residual_deg) << seed;
        EXPECT_GT(fit.before_m_per_s2, 3 * fit.accel.residual) << seed;
    }
}

TEST(HandCalibration, TooFewPositionsAndOneAxisAreRefused) {
    const HandFit few = calibrateByHand(layDown(2, 5).samples, kStandardGravity_m_per_s2);
    EXPECT_NE(few.problem.find("different positions"), std::string::npos) << few.problem;
    const HandFit flat = calibrateByHand(layDown(2, 40, false).samples, kStandardGravity_m_per_s2);
    EXPECT_FALSE(flat.problem.empty());
    ImuSamples nothing;
    nothing.rate_hz = 100;
    EXPECT_FALSE(calibrateByHand(nothing, kStandardGravity_m_per_s2).problem.empty());
}

}  // namespace
}  // namespace noctule::test
