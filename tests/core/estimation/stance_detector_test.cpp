// SPDX-License-Identifier: Apache-2.0
// A foot's board on made readings: what stands and what does not.
#include "core/estimation/stance_detector.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/inertial/reading.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

constexpr double kFrame_s = 1.0 / kInertialFramesPerSecond;
const Vector3d kContact_m(0.02, -0.05, 0.1);  // in the board's frame
const Vector3d kUp_board = Vector3d(0.1, 1, -0.2).normalized();

/// What the board senses, without noise.
struct Sensed {
    Vector3d omega_rad_per_s, force_m_per_s2;
};
using Motion = std::function<Sensed(double time_s)>;

Vector3d gravity() {
    return kStandardGravity_m_per_s2 * kUp_board;
}

Sensed still(double) {
    return {Vector3d::Zero(), gravity()};
}

/// The board of a foot that turns about the point of contact.
Motion turningAboutContact(const Vector3d& omega) {
    return [omega](double) { return Sensed{omega, gravity() + omega.cross(omega.cross(-kContact_m))}; };
}

struct Heard {
    std::vector<double> stands_s;   ///< instants at which the foot counted as standing
    std::optional<double> since_s;  ///< at the first of them
    double share(double from_s, double to_s) const {
        const auto within =
            std::ranges::count_if(stands_s, [&](double t) { return t >= from_s && t < to_s; });
        return static_cast<double>(within) * kFrame_s / (to_s - from_s);
    }
};

constexpr double kGyroNoise = 0.01, kAccelNoise = 0.1;

Heard hear(
    const Motion& motion, double seconds, StanceParameters parameters = {},
    const std::function<bool(double)>& lost = [](double) { return false; }) {
    StanceDetector detector(parameters, kContact_m);
    testing::Gaussian random(3);
    Heard heard;
    for (double t = 0; t < seconds; t += kFrame_s) {
        const Sensed sensed = motion(t);
        InertialMeasurement m{0, t, {}, {}};
        for (int i = 0; i < 3 && !lost(t); ++i) {
            m.gyro.add({Vector3d::Unit(i), sensed.omega_rad_per_s[i] + random(kGyroNoise), kGyroNoise});
            m.accel.add({Vector3d::Unit(i), sensed.force_m_per_s2[i] + random(kAccelNoise), kAccelNoise});
        }
        detector.add(m, Vector3d::Zero());
        if (const auto since_s = detector.standsSince_s(t)) {
            heard.stands_s.push_back(t);
            heard.since_s = heard.since_s.value_or(*since_s);
        }
    }
    return heard;
}

TEST(StanceDetector, standsAfterTheLeastTimeAndKnowsSinceWhen) {
    const StanceParameters parameters;
    const Heard heard = hear(still, 1);
    ASSERT_FALSE(heard.stands_s.empty());
    EXPECT_NEAR(heard.stands_s.front(), parameters.least_contact_s, 1.5 * kFrame_s);
    EXPECT_LT(*heard.since_s, 2.5 * kFrame_s);
    EXPECT_GT(heard.share(0.1, 1), 0.98);
}

TEST(StanceDetector, aSwingIsNoContactAndItsEndIsSeenAtOnce) {
    // Stands, swings from 0.5 to 0.9 s with 2 m of way, stands.
    const auto motion = [](double t) {
        if (t < 0.5 || t > 0.9)
            return still(t);
        const double phase = 2 * std::numbers::pi * (t - 0.5) / 0.4;
        return Sensed{{3 * std::sin(phase), 0, 0}, gravity() + Vector3d(0, 0, 60 * std::sin(phase))};
    };
    const Heard heard = hear(motion, 1.5);
    EXPECT_GT(heard.share(0.1, 0.5), 0.97);
    EXPECT_EQ(heard.share(0.54, 0.93), 0);
    EXPECT_GT(heard.share(1.05, 1.5), 0.97);
}

TEST(StanceDetector, aHopFeelsNoGravity) {
    const auto flight = [](double) { return Sensed{Vector3d::Zero(), Vector3d::Zero()}; };
    EXPECT_TRUE(hear(flight, 1).stands_s.empty());
}

TEST(StanceDetector, aQuietFootThatIsPushedIsNotStanding) {
    const auto pushed = [](double) { return Sensed{Vector3d::Zero(), 1.4 * gravity()}; };
    EXPECT_TRUE(hear(pushed, 1).stands_s.empty());
    StanceParameters alone;
    alone.uses_accelerometers = false;  // then nothing tells
    EXPECT_FALSE(hear(pushed, 1, alone).stands_s.empty());
}

TEST(StanceDetector, aFootThatTurnsAboutTheContactStands) {
    const Vector3d omega(0.9, 0, 0.2);
    EXPECT_GT(hear(turningAboutContact(omega), 1).share(0.1, 1), 0.97);
    // About another point with the same rate it is carried along: the force at the contact is not gravity.
    const auto elsewhere = [](double) {
        const Vector3d same(0.9, 0, 0.2);
        return Sensed{same, gravity() + same.cross(same.cross(Vector3d(0, 2.5, 0)))};
    };
    EXPECT_TRUE(hear(elsewhere, 1).stands_s.empty());
}

TEST(StanceDetector, theForceIsCarriedToTheContactWithItsSign) {
    // Rocks about the contact ten times a second, hardly turning: the board is pushed to and fro by 5 m/s^2.
    constexpr double kRate_rad_per_s = 0.8, kPhase_rad_per_s = 20 * std::numbers::pi;
    const auto rocking = [](const Vector3d& p_board_pivot_m) {
        return [=](double t) {
            const Vector3d omega(kRate_rad_per_s * std::sin(kPhase_rad_per_s * t), 0, 0);
            const Vector3d alpha(kRate_rad_per_s * kPhase_rad_per_s * std::cos(kPhase_rad_per_s * t), 0, 0);
            return Sensed{
                omega, gravity() - alpha.cross(p_board_pivot_m) - omega.cross(omega.cross(p_board_pivot_m))};
        };
    };
    EXPECT_GT(hear(rocking(kContact_m), 1).share(0.1, 1), 0.97);
    EXPECT_TRUE(hear(rocking(Vector3d::Zero()), 1).stands_s.empty()) << "about the board the contact moves";
    EXPECT_TRUE(hear(rocking(-kContact_m), 1).stands_s.empty());
    // Turns fast and evenly, were that allowed: the pull to the middle, too.
    StanceParameters turns;
    turns.rolling_rad_per_s = 40;
    EXPECT_GT(hear(turningAboutContact({12, 0, 0}), 1, turns).share(0.1, 1), 0.97);
    const auto outward = [](double) {
        const Vector3d omega(12, 0, 0);
        return Sensed{omega, gravity() - omega.cross(omega.cross(-kContact_m))};
    };
    EXPECT_TRUE(hear(outward, 1, turns).stands_s.empty());
}

TEST(StanceDetector, whatIsKnownHoldsUntilReadingsSayOtherwise) {
    StanceDetector detector({}, kContact_m);
    detector.standsFrom(0, 1);
    EXPECT_EQ(detector.standsSince_s(1.01), 0);
    EXPECT_FALSE(detector.standsSince_s(1.2)) << "nothing has been heard";
    detector.standsFrom(0, 1);
    const auto add = [&](double t, const Vector3d& force) {
        InertialMeasurement m{0, t, {}, {}};
        for (int i = 0; i < 3; ++i) {
            m.gyro.add({Vector3d::Unit(i), 0, kGyroNoise});
            m.accel.add({Vector3d::Unit(i), force[i], kAccelNoise});
        }
        detector.add(m, Vector3d::Zero());
    };
    double t = 1;
    for (; t < 1.5; t += kFrame_s) {
        add(t, gravity());
        EXPECT_EQ(detector.standsSince_s(t), 0);
    }
    for (; t < 1.6; t += kFrame_s)
        add(t, 2 * gravity());
    EXPECT_FALSE(detector.standsSince_s(t));
}

TEST(StanceDetector, whatIsNotHeardDoesNotStand) {
    const auto lost = [](double t) { return t >= 0.5 && t < 0.8; };
    const StanceParameters parameters;
    const Heard heard = hear(still, 1.2, parameters, lost);
    EXPECT_EQ(heard.share(0.5 + parameters.longest_silence_s, 0.8 + parameters.least_contact_s), 0);
    EXPECT_GT(heard.share(0.9, 1.2), 0.97);
}

TEST(StanceDetector, largerNoiseIsAllowedFor) {
    // Rounding of the coded stream: known, and as large as what a standing foot may do.
    testing::Gaussian random(5);
    StanceDetector told({}, kContact_m), untold({}, kContact_m);
    int told_stands = 0, untold_stands = 0;
    constexpr int kCount = 700;
    for (int k = 0; k < kCount; ++k) {
        InertialMeasurement m{0, k * kFrame_s, {}, {}};
        for (int i = 0; i < 3; ++i) {
            m.gyro.add({Vector3d::Unit(i), random(0.2), 0.2});
            m.accel.add({Vector3d::Unit(i), gravity()[i] + random(2.0), 2.0});
        }
        told.add(m, Vector3d::Zero());
        told_stands += told.standsSince_s(m.time_s).has_value();
        for (int i = 0; i < 3; ++i)
            m.gyro.axes[static_cast<size_t>(i)].sigma = m.accel.axes[static_cast<size_t>(i)].sigma = 0;
        untold.add(m, Vector3d::Zero());
        untold_stands += untold.standsSince_s(m.time_s).has_value();
    }
    EXPECT_GT(told_stands, 0.95 * kCount);
    EXPECT_LT(untold_stands, 0.05 * kCount);
}

}  // namespace
}  // namespace noctule
