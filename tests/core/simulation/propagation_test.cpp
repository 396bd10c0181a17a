// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/propagation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/simulation/random.h"
#include "tests/core/simulation/sound_test_world.h"

namespace noctule::simulation {
namespace {

using std::numbers::pi;
const WorldCapsule kUpright{{0, -0.5, 0}, {0, 0.5, 0}, 0.08, 0};

double straightDetour(double p, double q, double radius) {
    const double arc = pi - std::acos(radius / p) - std::acos(radius / q);
    return std::sqrt(p * p - radius * radius) + std::sqrt(q * q - radius * radius) + radius * arc - p - q;
}

/// The shortest way by brute force: a string of many beads that pulls itself taut and never enters the
/// capsule.
double tautString(const WorldCapsule& capsule, const Vector3d& from, const Vector3d& to,
                  const Vector3d& over) {
    constexpr int kBeads = 48;
    std::vector<Vector3d> beads;
    for (int i = 0; i <= kBeads; ++i) {
        const double s = 2.0 * i / kBeads;
        beads.push_back(s < 1 ? Vector3d(from + s * (over - from)) : Vector3d(over + (s - 1) * (to - over)));
    }
    const Vector3d ab = capsule.b_m - capsule.a_m;
    for (int round = 0; round < 5000; ++round) {
        for (size_t i = 1; i < kBeads; ++i) {
            Vector3d bead = 0.5 * (beads[i - 1] + beads[i + 1]);
            const double s =
                std::clamp((bead - capsule.a_m).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
            const Vector3d on_axis = capsule.a_m + s * ab;
            if ((bead - on_axis).norm() < capsule.radius_m)
                bead = on_axis + capsule.radius_m * (bead - on_axis).normalized();
            beads[i] = bead;
        }
    }
    double length = 0;
    for (size_t i = 1; i < beads.size(); ++i)
        length += (beads[i] - beads[i - 1]).norm();
    return length;
}

TEST(Directivity, IsThePistonsInFront) {
    // Values of J1 from Abramowitz and Stegun, table 9.1.
    EXPECT_NEAR(pistonDirectivity(3.0, 1.0), 1.0, 1e-15);
    EXPECT_NEAR(pistonDirectivity(1.0, 0.0), 2 * 0.4400505857, 1e-9);
    EXPECT_NEAR(pistonDirectivity(2.0, 0.0), 0.5767248078, 1e-9);
    EXPECT_NEAR(pistonDirectivity(3.0, 0.0), 2 * 0.3390589585 / 3, 1e-9);
    for (double angle = 0.05; angle < pi / 2; angle += 0.05) {
        const double x = 3.6 * std::sin(angle);
        EXPECT_NEAR(pistonDirectivity(3.6, std::cos(angle)), 2 * std::cyl_bessel_j(1, x) / x, 1e-12);
    }
}

TEST(Directivity, Is20DbDownBehind) {
    EXPECT_DOUBLE_EQ(pistonDirectivity(3.2, -0.01), 0.1);
    EXPECT_DOUBLE_EQ(pistonDirectivity(3.2, -1), 0.1);
}

TEST(Air, SpreadsAndAbsorbs) {
    EXPECT_DOUBLE_EQ(airGain(1, 0), 1);
    EXPECT_NEAR(airGain(2, 0), 0.5, 1e-15);
    EXPECT_NEAR(20 * std::log10(airGain(0.5, 1.3)), 20 * std::log10(2.0) - 0.65, 1e-12);
    EXPECT_NEAR(20 * std::log10(airGain(2, 1.3)), -20 * std::log10(2.0) - 2.6, 1e-12);
    EXPECT_TRUE(std::isfinite(airGain(0, 1.3)));
}

TEST(Occlusion, SeesWhatIsInTheWay) {
    EXPECT_TRUE(blocks(kUpright, {-0.3, 0, 0}, {0.3, 0, 0}));
    EXPECT_TRUE(blocks(kUpright, {-0.3, 0, 0.079}, {0.3, 0, 0.079}));
    EXPECT_FALSE(blocks(kUpright, {-0.3, 0, 0.081}, {0.3, 0, 0.081}));
    EXPECT_TRUE(blocks(kUpright, {-0.3, 0.57, 0}, {0.3, 0.57, 0}));   // through the rounded end
    EXPECT_FALSE(blocks(kUpright, {-0.3, 0.59, 0}, {0.3, 0.59, 0}));  // over it
    EXPECT_FALSE(blocks(kUpright, {0.1, 0, 0}, {0.3, 0, 0}));         // beside
    EXPECT_TRUE(blocks(kUpright, {0.01, 0.9, 0}, {0.01, -0.9, 0}));   // along the axis
    EXPECT_FALSE(blocks(kUpright, {0.3, 0.9, 0}, {0.3, -0.9, 0}));
    EXPECT_FALSE(blocks(kUpright, {0.3, 0, 0}, {0.3, 0, 0}));
}

TEST(Occlusion, AnOwnLimbShadowsOnlyItsFarSide) {
    const Vector3d ahead(0.5, 0, 0), behind(-0.5, 0, 0), grazing(0.09, 0.4, 0.4);
    const Vector3d strapped(0.09, 0, 0), pushed_in(0.07, 0, 0), deep(0.03, 0, 0);
    for (const Vector3d& board : {strapped, pushed_in, deep}) {
        EXPECT_FALSE(blocks(kUpright, board, ahead));
        EXPECT_FALSE(blocks(kUpright, board, grazing));
        EXPECT_TRUE(blocks(kUpright, board, behind)) << board.transpose();
        EXPECT_EQ(blocks(kUpright, board, behind), blocks(kUpright, behind, board));
    }
}

TEST(Detour, AroundACylinderIsTheTautString) {
    EXPECT_NEAR(detourAround(kUpright, {-0.3, 0, 0}, {0.3, 0, 0}), straightDetour(0.3, 0.3, 0.08), 1e-9);
    EXPECT_NEAR(detourAround(kUpright, {-0.09, 0, 0}, {0.3, 0, 0}), straightDetour(0.09, 0.3, 0.08), 1e-9);
    EXPECT_DOUBLE_EQ(detourAround(kUpright, {-0.3, 0, 0.1}, {0.3, 0, 0.1}), 0);
    // The unrolled cylinder: a slanted way is a right triangle.
    const double across = 0.6 + straightDetour(0.3, 0.3, 0.08);
    EXPECT_NEAR(detourAround(kUpright, {-0.3, -0.2, 0}, {0.3, 0.2, 0}),
                std::hypot(across, 0.4) - std::hypot(0.6, 0.4), 1e-9);
}

TEST(Detour, AroundASphereAndOverAnEnd) {
    const WorldCapsule ball{{0, 0, 0}, {0, 0, 0}, 0.08, 0};
    EXPECT_NEAR(detourAround(ball, {0, -0.2, 0}, {0, 0.3, 0}), straightDetour(0.2, 0.3, 0.08), 2e-4);
    const double over = detourAround(kUpright, {-0.3, 0.5, 0}, {0.3, 0.5, 0});
    EXPECT_NEAR(over, straightDetour(0.3, 0.3, 0.08), 2e-4);
    EXPECT_LT(detourAround(kUpright, {-0.3, 0.56, 0}, {0.3, 0.56, 0}), 0.3 * over);
}

TEST(Detour, AgreesWithAStringOfBeads) {
    Random random(11, "detour test");
    const WorldCapsule capsule{{0, -0.15, 0}, {0, 0.15, 0}, 0.07, 0};
    const auto fromAxis = [](const Vector3d& p) {
        return (p - Vector3d(0, std::clamp(p.y(), -0.15, 0.15), 0)).norm();
    };
    for (int tried = 0; tried < 40;) {
        const Vector3d from = random.gaussianVector(0.2), to = random.gaussianVector(0.25);
        if (!blocks(capsule, from, to) || fromAxis(from) < 0.085 || fromAxis(to) < 0.085)
            continue;
        ++tried;
        double best = 1e9;
        for (const Vector3d& over : {Vector3d(0, 0.5, 0), Vector3d(0, -0.5, 0), Vector3d(0.4, 0, 0),
                                     Vector3d(-0.4, 0, 0), Vector3d(0, 0, 0.4), Vector3d(0, 0, -0.4)})
            best = std::min(best, tautString(capsule, from, to, over));
        const double detour = detourAround(capsule, from, to), truth = best - (to - from).norm();
        EXPECT_GT(detour, truth - 1e-3) << from.transpose() << " to " << to.transpose();
        EXPECT_LT(detour, truth + 4e-3) << from.transpose() << " to " << to.transpose();
    }
}

TEST(DirectPath, KnowsAnglesSidesAndLevels) {
    const Medium medium{.absorption_db_per_m = 1.3};
    const DirectPath front = directPath({{0, 1, 0}, {0, 0, 1}, {0, 1, 2}}, {}, 3.2, medium);
    EXPECT_DOUBLE_EQ(front.distance_m, 2);
    EXPECT_DOUBLE_EQ(front.angle_rad, 0);
    EXPECT_FALSE(front.occluded || front.behind_source);
    EXPECT_DOUBLE_EQ(front.gain, airGain(2, 1.3));
    const DirectPath behind = directPath({{0, 1, 0}, {0, 0, 1}, {0, 1, -2}}, {}, 3.2, medium);
    EXPECT_TRUE(behind.behind_source);
    EXPECT_NEAR(behind.angle_rad, pi, 1e-12);
    EXPECT_DOUBLE_EQ(behind.gain, 0.1 * airGain(2, 1.3));
}

TEST(DirectPath, GoesAroundWhatOccludes) {
    const PathEnds ends{{-0.3, 0, 0}, {1, 0, 0}, {0.3, 0, 0}};
    const DirectPath path = directPath(ends, {kUpright}, 3.2, {});
    EXPECT_TRUE(path.occluded);
    EXPECT_NEAR(path.detour_m, straightDetour(0.3, 0.3, 0.08), 1e-9);
    EXPECT_NEAR(20 * std::log10(path.gain / airGain(0.6, 1.3)), -20 - 400 * path.detour_m, 1e-9);
    EXPECT_EQ(directPath(ends, {kUpright}, 3.2, {.late_path = false}).gain, 0);
    EXPECT_FALSE(directPath(ends, {kUpright}, 3.2, {.occlusion = false}).occluded);
    EXPECT_EQ(directPath(ends, {}, 3.2, {}).detour_m, 0);
}

TEST(DirectFlight, MeetsAMicrophoneThatFlees) {
    TestWorld world;
    world.sources = {{.p_m = {0, 0, 0}, .v_m_per_s = {5, 0, 0}}};
    world.boards = {{.p_m = {1, 0, 0}, .v_m_per_s = {10, 0, 0}}};
    // At 0.1 s the source is at 0.5 m, the microphone at 2 m: 345 t = 1.5 + 10 t.
    const Flight flight = directFlight(world, 0, 0, 0.1, 345);
    EXPECT_NEAR(flight.arrival_s, 0.1 + 1.5 / 335, 1e-12);
    EXPECT_NEAR(flight.distance_m, 345 * 1.5 / 335, 1e-9);
}

}  // namespace
}  // namespace noctule::simulation
