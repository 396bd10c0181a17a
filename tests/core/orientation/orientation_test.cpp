// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/math/rotation.h"
#include "core/orientation/complementary_filters.h"
#include "core/orientation/error_filter.h"
#include "core/orientation/orientation_estimators.h"
#include "core/orientation/orientation_score.h"

namespace noctule {
namespace {

/// A sensor that is turned and waved about one place, and what it reads. The truth is a formula of its own:
/// sums of sines as Euler angles, differentiated numerically.
struct Waved {
    ImuSamples samples;
    std::vector<Quaterniond> truth;
};

Quaterniond attitudeAt(double t, double phase) {
    const double ramp = 1 - std::exp(-t / 3);  // begins at rest
    return axisAngle(Vector3d::UnitY(), ramp * (1.2 * std::sin(0.9 * t + phase) + 0.5 * std::sin(2.3 * t))) *
           axisAngle(Vector3d::UnitX(), ramp * 0.8 * std::sin(1.3 * t + 2 * phase)) *
           axisAngle(Vector3d::UnitZ(), ramp * 0.9 * std::sin(1.7 * t));
}

Vector3d placeAt(double t, double phase) {
    const double ramp = 1 - std::exp(-t / 3);
    return ramp * Vector3d(0.3 * std::sin(2.1 * t + phase), 0.2 * std::sin(3.3 * t), 0.3 * std::cos(1.9 * t));
}

struct WavedErrors {
    Vector3d gyro_bias = Vector3d(0.01, -0.006, 0.008);
    double mag_lag_s = 0, noise = 1, bend_rad = 0;
};

Waved wave(int seed, double seconds, double rate_hz, const WavedErrors& errors) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::normal_distribution<double> normal;
    const auto noise = [&](double sigma) {
        return Vector3d{errors.noise * sigma * Vector3d{normal(random), normal(random), normal(random)}};
    };
    const double phase = 0.7 * seed, dt = 1 / rate_hz, h = 1e-4;
    const Vector3d field(0, -45 * std::sin(1.15), 45 * std::cos(1.15));
    Waved waved;
    waved.samples.rate_hz = rate_hz;
    for (int i = 0; i < int(seconds * rate_hz); ++i) {
        const double t = i * dt;
        const Quaterniond q = attitudeAt(t, phase), q_end = attitudeAt(t + dt, phase);
        const double middle = t + dt / 2;
        const Vector3d accel =
            (placeAt(middle + h, phase) - 2 * placeAt(middle, phase) + placeAt(middle - h, phase)) / (h * h);
        const bool bent = errors.bend_rad != 0 && t > 20 && t < 26;
        const Quaterniond bend = axisAngle(Vector3d::UnitY(), bent ? errors.bend_rad : 0);
        waved.samples.gyro_rad_per_s.push_back(logQuaternion(q.conjugate() * q_end) / dt + errors.gyro_bias +
                                               noise(0.01));
        waved.samples.accel_m_per_s2.push_back(
            attitudeAt(middle, phase).conjugate() *
                Vector3d(accel + Vector3d(0, kStandardGravity_m_per_s2, 0)) +
            noise(0.05));
        waved.samples.mag.push_back(attitudeAt(t - errors.mag_lag_s, phase).conjugate() *
                                        Vector3d(bend * (bent ? Vector3d(1.3 * field) : field)) +
                                    noise(0.5));
        waved.truth.push_back(q_end);
    }
    return waved;
}

OrientationRun estimate(const Waved& waved, bool smooth) {
    OrientationSettings settings;
    settings.smooth = smooth;
    return estimateOrientation(waved.samples, settings, {}).value();
}

OrientationScore scoreOf(const std::vector<Quaterniond>& estimate, const Waved& waved) {
    std::vector<char> counts(waved.truth.size(), 1);
    std::fill_n(counts.begin(), counts.size() / 4, char(0));
    return scoreOrientation(estimate, waved.truth, counts);
}

TEST(OrientationScore, PartsAreAnglesAboutTheVerticalAndAcrossIt) {
    const std::vector<Quaterniond> truth(4, Quaterniond::Identity());
    std::vector<Quaterniond> estimate;
    for (const double heading : {0.3, 0.3, 0.3, 0.3})
        estimate.push_back(axisAngle(Vector3d::UnitY(), heading) * axisAngle(Vector3d::UnitX(), radians(5)));
    const OrientationScore score = scoreOrientation(estimate, truth, {});
    EXPECT_NEAR(score.heading_offset_deg, degrees(0.3), 1e-9);
    EXPECT_NEAR(score.inclination_deg, 5, 1e-6);
    EXPECT_NEAR(score.heading_deg, degrees(0.3), 1e-6);
    EXPECT_NEAR(score.total_deg, degrees(2 * std::acos(std::cos(0.15) * std::cos(radians(2.5)))), 1e-6);
    EXPECT_NEAR(score.heading_turned_deg, 0, 1e-6);
    EXPECT_NEAR(score.total_turned_deg, 5, 1e-6);
    EXPECT_EQ(score.samples, 4u);
}

TEST(OrientationScore, RowsThatDoNotCountAndGapsAreLeftOut) {
    const double nan = std::nan("");
    const std::vector<Quaterniond> truth{Quaterniond::Identity(), Quaterniond(nan, nan, nan, nan),
                                         Quaterniond::Identity()};
    const std::vector<Quaterniond> estimate(3, axisAngle(Vector3d::UnitZ(), 0.1));
    EXPECT_EQ(scoreOrientation(estimate, truth, {1, 1, 0}).samples, 1u);
    EXPECT_EQ(scoreOrientation(estimate, truth, {0, 1, 0}).samples, 0u);
}

TEST(OrientationTransition, AgreesWithDifferencesOfTheIntegratedReadings) {
    const Waved waved = wave(3, 2, 200, {Vector3d::Zero(), 0, 0, 0});
    // Integrates ten readings from a nominal state; the error state's transition must tell what a small error
    // does.
    using namespace orientation;
    const auto integrate = [&](Nominal state, Transition* t) {
        for (size_t i = 200; i < 210; ++i) {
            const double dt = 1.0 / 200;
            const Matrix3d R = state.q_world_sensor.toRotationMatrix();
            const Vector3d reading = waved.samples.gyro_rad_per_s[i];
            const Vector3d force = R * (waved.samples.accel_m_per_s2[i] - state.accel_bias_m_per_s2) * dt;
            if (t) {
                t->turn_by_bias -= dt * R;
                t->turn_by_scale += dt * (R * reading.asDiagonal());
                t->force_dt += force;
                t->dt_s += dt;
            }
            state.place_m += dt * state.velocity_m_per_s;
            state.velocity_m_per_s += force - Vector3d(0, kStandardGravity_m_per_s2 * dt, 0);
            state.q_world_sensor = state.q_world_sensor * expQuaternion(state.rate(reading) * dt);
        }
        return state;
    };
    Nominal begin;
    begin.q_world_sensor = waved.truth[199];
    Transition t;
    const Nominal end = integrate(begin, &t);
    ErrorMatrix F = ErrorMatrix::Identity();
    applyTransition(t, F);
    for (int column = 0; column < 18; ++column) {
        const double h = 1e-5;
        Nominal moved = begin;
        moved.add(h * ErrorVector::Unit(column));
        const Nominal there = integrate(moved, nullptr);
        ErrorVector difference = ErrorVector::Zero();
        difference.segment<3>(kTurn) =
            logQuaternion(there.q_world_sensor * end.q_world_sensor.conjugate()) / h;
        difference.segment<3>(kVelocity) = (there.velocity_m_per_s - end.velocity_m_per_s) / h;
        difference.segment<3>(kPlace) = (there.place_m - end.place_m) / h;
        // Couplings within the step are left out: of second order in its 50 ms.
        EXPECT_LT((difference.head<9>() - F.col(column).head<9>()).norm(), 0.03) << "column " << column;
    }
}

TEST(OrientationFilter, FindsAttitudeBiasAndLag) {
    double total = 0, smoothed = 0;
    constexpr int kSeeds = 20;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        WavedErrors errors;
        errors.mag_lag_s = 0.014;
        const Waved waved = wave(seed, 60, 200, errors);
        const OrientationRun run = estimate(waved, false);
        EXPECT_LT((run.gyro_bias_rad_per_s - errors.gyro_bias).norm(), 0.004) << "seed " << seed;
        EXPECT_NEAR(run.mag_lag_s, 0.014, 4 * run.mag_lag_sigma_s + 0.001) << "seed " << seed;
        total += scoreOf(run.q_world_sensor, waved).total_turned_deg / kSeeds;
        smoothed += scoreOf(estimate(waved, true).q_world_sensor, waved).total_turned_deg / kSeeds;
    }
    EXPECT_LT(total, 1.0);
    EXPECT_LT(smoothed, total);
}

TEST(OrientationFilter, ABentFieldTurnsTheHeadingOnlyALittle) {
    WavedErrors errors;
    errors.bend_rad = 0.8;
    const Waved waved = wave(5, 60, 200, errors);
    EXPECT_LT(scoreOf(estimate(waved, false).q_world_sensor, waved).heading_turned_deg, 4);
    EXPECT_GT(scoreOf(bachmannOrientation(waved.samples, {2}), waved).heading_turned_deg, 6)
        << "the disturbance is one that turns a filter which believes the field";
}

TEST(OrientationFilter, WithoutAMagnetometerTheHeadingGrowsUnsure) {
    Waved waved = wave(2, 60, 200, {});
    waved.samples.mag.clear();
    const OrientationRun run = estimate(waved, false);
    // No reading and no pseudo-measurement tells north. What the gyroscope's bias added may be learnt later,
    // so sigma may fall again, but never below that of the start.
    for (size_t i = 1; i < run.heading_sigma_rad.size(); ++i)
        ASSERT_GE(run.heading_sigma_rad[i], 0.2) << "reading " << i;
    EXPECT_GT(run.heading_sigma_rad.back(), run.heading_sigma_rad.front());
    EXPECT_LT(scoreOf(run.q_world_sensor, waved).inclination_deg, 1.5);
    EXPECT_EQ(run.mag_lag_s, 0);
}

TEST(OrientationFilter, FastTurnsDoNotTilt) {
    // Readings are means over their interval. A force turned as the sensor stood at the interval's begin
    // shows gravity 1.6 degrees off at this rate, always to one side.
    constexpr double kRate_rad_per_s = 8, kRate_hz = 285;
    const auto turned = [](double t) { return axisAngle(Vector3d::UnitX(), kRate_rad_per_s * t); };
    ImuSamples samples;
    samples.rate_hz = kRate_hz;
    std::vector<Quaterniond> truth;
    for (int i = 0; i < int(20 * kRate_hz); ++i) {
        const double moving = std::max(0.0, double(i) - kRate_hz);  // after one second at rest
        const double begin = moving / kRate_hz, middle = (moving > 0 ? moving + 0.5 : 0) / kRate_hz;
        samples.gyro_rad_per_s.push_back(Vector3d(i < kRate_hz ? 0 : kRate_rad_per_s, 0, 0));
        samples.accel_m_per_s2.push_back(turned(middle).conjugate() *
                                         Vector3d(0, kStandardGravity_m_per_s2, 0));
        truth.push_back(turned(i < kRate_hz ? 0 : begin + 1 / kRate_hz));
    }
    const auto run = estimateOrientation(samples, {}, {});
    ASSERT_TRUE(run);
    EXPECT_LT(scoreOrientation(run->q_world_sensor, truth, {}).inclination_deg, 0.2);
}

TEST(OrientationFilter, RestShowsTheGyroscopesBiasAboutTheVerticalToo) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const Vector3d bias(0.01, 0.015, -0.01);
    ImuSamples samples;
    samples.rate_hz = 100;
    for (int i = 0; i < 2000; ++i) {
        const auto noise = [&](double sigma) {
            return Vector3d{sigma * Vector3d{normal(random), normal(random), normal(random)}};
        };
        samples.gyro_rad_per_s.push_back(bias + noise(0.005));
        samples.accel_m_per_s2.push_back(Vector3d(0, kStandardGravity_m_per_s2, 0) + noise(0.05));
    }
    const auto run = estimateOrientation(samples, {}, {});
    ASSERT_TRUE(run);
    EXPECT_LT((run->gyro_bias_rad_per_s - bias).norm(), 1e-3) << "no magnetometer tells it";
}

TEST(OrientationFilter, LostReadingsAreBridged) {
    Waved waved = wave(4, 60, 200, {});
    const Vector3d nothing = Vector3d::Constant(std::nan(""));
    for (size_t i = 6000; i < 6030; ++i)
        waved.samples.gyro_rad_per_s[i] = waved.samples.accel_m_per_s2[i] = waved.samples.mag[i] = nothing;
    for (const bool smooth : {false, true}) {
        const OrientationRun run = estimate(waved, smooth);
        for (const Quaterniond& q : run.q_world_sensor)
            ASSERT_TRUE(q.coeffs().allFinite());
        EXPECT_LT(degrees(angleBetween(run.q_world_sensor.back(), waved.truth.back())), 6);
    }
}

/// Longer than the memory of the field, which is 2 % stronger afterwards.
TEST(OrientationFilter, AfterALongPauseTheMagnetometerStillTellsTheHeading) {
    constexpr int kBefore = 2000, kAfter = 6000;
    Waved still;
    still.samples.rate_hz = 100;
    still.samples.step_s.assign(kBefore + kAfter, 0.01);
    still.samples.step_s[kBefore] = 600;
    const Vector3d field(0, -45 * std::sin(1.15), 45 * std::cos(1.15));
    for (int i = 0; i < kBefore + kAfter; ++i) {
        const Quaterniond q = axisAngle(Vector3d::UnitY(), i < kBefore ? 0 : 1);
        still.samples.gyro_rad_per_s.push_back(Vector3d::Zero());
        still.samples.accel_m_per_s2.push_back({0, kStandardGravity_m_per_s2, 0});
        still.samples.mag.push_back(q.conjugate() * Vector3d((i < kBefore ? 1 : 1.02) * field));
        still.truth.push_back(q);
    }
    const auto attitudes = estimate(still, false).q_world_sensor;
    EXPECT_LT(degrees(angleBetween(attitudes.back(), still.truth.back())), 3);
}

TEST(OrientationFilter, IsCancelled) {
    CancelFlag cancel;
    cancel.cancel();
    const auto run = estimateOrientation(wave(1, 2, 200, {}).samples, {}, {nullptr, &cancel});
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().kind, ErrorKind::kCancelled);
}

TEST(MillerOrientation, ReturnsFromAWrongAttitudeInEveryPartition) {
    // A sensor at rest whose gyroscope lies about one axis: the correction must hold it in all three
    // partitions.
    for (const Quaterniond& rest : {Quaterniond::Identity(), axisAngle(Vector3d::UnitX(), radians(90)),
                                    axisAngle(Vector3d::UnitZ(), radians(90))})
        for (int axis = 0; axis < 3; ++axis) {
            ImuSamples samples;
            samples.rate_hz = 100;
            for (int i = 0; i < 6000; ++i) {
                samples.gyro_rad_per_s.push_back(0.02 * Vector3d::Unit(axis));
                samples.accel_m_per_s2.push_back(rest.conjugate() *
                                                 Vector3d(0, kStandardGravity_m_per_s2, 0));
                samples.mag.push_back(rest.conjugate() * Vector3d(0, 0, 20));
            }
            const auto run = millerOrientation(samples, {1, true});
            // Balance of drift and correction: 0.02 rad/s against 1/s.
            EXPECT_NEAR(degrees(angleBetween(run.back(), rest)), degrees(0.02), 0.3) << "axis " << axis;
        }
}

TEST(OrientationEstimators, AreFoundByName) {
    EXPECT_STREQ(orientationEstimators().front().name, "noctule");
    ASSERT_TRUE(findOrientationEstimator("bachmann"));
    EXPECT_FALSE(findOrientationEstimator("miler"));
}

}  // namespace
}  // namespace noctule
