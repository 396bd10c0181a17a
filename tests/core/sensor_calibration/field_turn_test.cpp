// SPDX-License-Identifier: Apache-2.0
// Simulated magnetometers that are turned by hand. Their iron is modelled here, as a rigid magnet and plates
// that are magnetised along one axis each, not as the ellipsoid of the fit.
#include "core/sensor_calibration/field_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace noctule::test {
namespace {

const Vector3d kEarthField_ut(20, -43.6, 0);  // 48 uT, dips 65 degrees

/// A plate of soft iron: what lies along its axis is made larger. Several of them, one after the other.
struct Plate {
    Vector3d axis;
    double gain;
};
struct Iron {
    Vector3d magnet_ut = Vector3d::Zero();
    std::vector<Plate> plates;

    Vector3d apply(Vector3d field) const {
        for (const Plate& plate : plates)
            field += plate.gain * plate.axis * plate.axis.dot(field);
        return field + magnet_ut;
    }
};

Iron usualIron(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector3d{normal(random), normal(random), normal(random)}; };
    Iron iron{12 * vector(), {}};
    for (const double gain : {0.06, -0.04})
        iron.plates.push_back({vector().normalized(), gain});
    return iron;
}

/// Attitudes of something that is rolled in all directions by hand, seven a second.
std::vector<Quaterniond> rolled(unsigned seed, int readings) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Quaterniond> attitudes;
    Quaterniond now = Quaterniond::Identity();
    Vector3d rate(0, 0, 0);
    for (int i = 0; i < readings; ++i) {
        rate = 0.9 * rate + 0.5 * Vector3d{normal(random), normal(random), normal(random)};
        const double angle = rate.norm() / 7;
        if (angle > 0)
            now = (Quaterniond(Eigen::AngleAxisd(angle, rate.normalized())) * now).normalized();
        attitudes.push_back(now);
    }
    return attitudes;
}

using FieldAt = std::function<Vector3d(int)>;

FieldTurn turned(
    const Iron& iron, const std::vector<Quaterniond>& attitudes, unsigned seed,
    const FieldAt& world = [](int) { return kEarthField_ut; }) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.3);
    FieldTurn turn;
    for (size_t i = 0; i < attitudes.size(); ++i)
        turn.add(iron.apply(attitudes[i].conjugate() * world(static_cast<int>(i))) +
                 Vector3d{noise(random), noise(random), noise(random)});
    turn.judge();
    return turn;
}

TEST(FieldSphere, CellsAreOfEqualAreaAndHoldTheirMiddles) {
    ASSERT_EQ(FieldSphere::cells().size(), size_t(FieldSphere::kCells));
    for (int cell = 0; cell < FieldSphere::kCells; ++cell) {
        const FieldCell& at = FieldSphere::cells()[static_cast<size_t>(cell)];
        EXPECT_NEAR((at.top - at.bottom) * (at.to_rad - at.from_rad), 4 * std::numbers::pi / 100, 1e-12);
        EXPECT_EQ(FieldSphere::cellOf(at.middle()), cell);
    }
    for (int side = 0; side < 6; ++side) {
        const int cell = FieldSphere::cellOf(directionOf(static_cast<FieldSide>(side)));
        EXPECT_GE(cell, 0);
        EXPECT_LT(cell, FieldSphere::kCells);
    }
}

TEST(FieldSphere, NamesTheSideThatIsEmpty) {
    for (int side = 0; side < 6; ++side) {
        FieldSphere sphere;
        const Vector3d empty = directionOf(static_cast<FieldSide>(side));
        for (const FieldCell& cell : FieldSphere::cells())
            if (cell.middle().dot(empty) < 0.6)
                sphere.add(3 * cell.middle());
        EXPECT_EQ(sphere.emptySide(), static_cast<FieldSide>(side));
        EXPECT_LT(sphere.share(), 0.9);
    }
    FieldSphere full;
    for (const FieldCell& cell : FieldSphere::cells())
        full.add(cell.middle());
    EXPECT_EQ(full.emptySide(), std::nullopt);
    EXPECT_EQ(full.share(), 1);
    full.keepLesser(FieldSphere{});
    EXPECT_EQ(full.seen(), 0);
}

TEST(FieldTurn, IronOfTheSensorItselfIsFound) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const Iron iron = usualIron(seed);
        const FieldTurn turn = turned(iron, rolled(seed, 2000), seed);
        EXPECT_EQ(turn.state(), FieldTurnState::kDone)
            << seed << ": " << turn.sphere().seen() << " of 100, " << turn.fit().problem;
        EXPECT_LT((turn.fit().ellipsoid.zero - iron.magnet_ut).norm(), 0.6) << seed;
        ASSERT_TRUE(turn.uneven_percent());
        EXPECT_LT(*turn.uneven_percent(), 1.5);
        EXPECT_LT(turn.zero_sigma_percent().value_or(100), 1);
    }
}

TEST(FieldTurn, ABuckleThatMovesWithTheSensorIsPartOfIt) {
    Iron iron = usualIron(3);
    iron.magnet_ut += Vector3d(25, -10, 5);
    const FieldTurn turn = turned(iron, rolled(3, 2000), 3);
    EXPECT_EQ(turn.state(), FieldTurnState::kDone);
    EXPECT_LT((turn.fit().ellipsoid.zero - iron.magnet_ut).norm(), 0.6);
}

TEST(FieldTurn, TurnedInOnePlaneItIsNotDone) {
    std::vector<Quaterniond> attitudes;
    for (int i = 0; i < 2000; ++i)
        attitudes.emplace_back(Eigen::AngleAxisd(0.1 * i, Vector3d::UnitZ()));
    const FieldTurn turn = turned(usualIron(4), attitudes, 4);
    EXPECT_EQ(turn.state(), FieldTurnState::kGoing);
    EXPECT_LT(turn.sphere().share(), 0.5);
    ASSERT_TRUE(turn.sphere().emptySide());
    const FieldSide empty = *turn.sphere().emptySide();
    EXPECT_TRUE(empty == FieldSide::kFront || empty == FieldSide::kBack) << static_cast<int>(empty);
}

TEST(FieldTurn, ABentFieldIsUneven) {
    // Beside a table: the strength differs by a quarter between two places that it is carried between.
    const FieldTurn turn = turned(usualIron(5), rolled(5, 2000), 5, [](int i) {
        return Vector3d(kEarthField_ut * (1 + 0.25 * std::sin(0.05 * i)));
    });
    EXPECT_EQ(turn.state(), FieldTurnState::kUneven);
}

TEST(FieldTurn, NoReadingsAndBadOnesAreSaid) {
    FieldTurn nothing;
    nothing.judge();
    EXPECT_EQ(nothing.state(), FieldTurnState::kGoing);
    EXPECT_EQ(nothing.sphere().seen(), 0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    FieldTurn missing = turned(usualIron(6), rolled(6, 2000), 6);
    missing.add({nan, 1, 2});
    missing.judge();
    EXPECT_EQ(missing.state(), FieldTurnState::kDone);
    EXPECT_EQ(missing.readings().size(), 2000u);
    FieldTurn zero;
    for (int i = 0; i < 300; ++i)
        zero.add(Vector3d::Zero());
    zero.judge();
    EXPECT_EQ(zero.state(), FieldTurnState::kNoField);
    EXPECT_FALSE(zero.uneven_percent());
}

TEST(FieldTurn, AFieldBeyondTheRangeIsSaid) {
    Iron iron = usualIron(7);
    iron.magnet_ut = {85, 0, 0};
    std::mt19937 random(7);
    FieldTurn turn;
    for (const Quaterniond& attitude : rolled(7, 2000))
        turn.add(iron.apply(attitude.conjugate() * kEarthField_ut)
                     .cwiseMin(FieldTurnLimits::kFullScale_ut * 2047 / 2048)
                     .cwiseMax(-FieldTurnLimits::kFullScale_ut));
    turn.judge();
    EXPECT_EQ(turn.state(), FieldTurnState::kClipped);
}

TEST(FieldTurn, IronBesideOneSensorIsTold) {
    EXPECT_EQ(carriesIron({0.8, 1.1, 6.4, 0.9}), (std::vector<bool>{false, false, true, false}));
    EXPECT_EQ(carriesIron({6.1, 7.0, 6.4, 5.9}), std::vector<bool>(4)) << "the place is bent, not one sensor";
    EXPECT_EQ(carriesIron({9.0}), std::vector<bool>(1)) << "one alone cannot tell";
    EXPECT_EQ(carriesIron({std::nullopt, 9.0, std::nullopt}), std::vector<bool>(3));
}

std::vector<SpotMoment> carried(const FieldAt& world, size_t sensors) {
    std::mt19937 random(9);
    std::normal_distribution<double> tilt(0, 0.05);
    std::vector<SpotMoment> moments;
    for (int i = 0; i < 60; ++i) {
        SpotMoment moment;
        for (size_t sensor = 0; sensor < sensors; ++sensor) {
            const Quaterniond attitude(Eigen::AngleAxisd(tilt(random), Vector3d::UnitX()));
            moment.field_ut.emplace_back(attitude.conjugate() * world(i));
            moment.up.emplace_back(attitude.conjugate() * Vector3d::UnitY());
        }
        moments.push_back(moment);
    }
    return moments;
}

TEST(SpotField, StrengthDipAndEvenness) {
    const SpotField spot = spotField(carried([](int) { return kEarthField_ut; }, 5));
    EXPECT_TRUE(spot.isEven());
    EXPECT_NEAR(spot.strength_ut, 48, 0.1);
    ASSERT_TRUE(spot.dip_deg);
    EXPECT_NEAR(*spot.dip_deg, 65.4, 1);
    EXPECT_LT(spot.uneven_percent, 0.5);
    const SpotField bent = spotField(
        carried([](int i) { return Vector3d(kEarthField_ut * (1 + 0.12 * std::sin(0.1 * i))); }, 5));
    EXPECT_FALSE(bent.isEven());
    EXPECT_NEAR(bent.uneven_percent, 12, 3);
    const auto at = [](double strength) {
        return carried([strength](int) { return Vector3d(strength * kEarthField_ut); }, 5);
    };
    EXPECT_NEAR(strongerBy_percent(at(1), at(1.12)).value_or(0), 12, 0.5);
    EXPECT_NEAR(strongerBy_percent(at(1), at(0.9)).value_or(0), -10, 0.5);
    EXPECT_FALSE(strongerBy_percent(at(1), {}));
    EXPECT_FALSE(spotField({}).isEven());
    EXPECT_FALSE(spotField(carried([](int) { return Vector3d(Vector3d::Zero()); }, 2)).isEven());
}

}  // namespace
}  // namespace noctule::test
