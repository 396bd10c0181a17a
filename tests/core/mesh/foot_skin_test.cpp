// SPDX-License-Identifier: Apache-2.0
// What of a foot can touch the floor, and how far it turns not to go below.
#include "core/mesh/retarget/foot_skin.h"

#include <gtest/gtest.h>

#include <random>

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// A ball of skin on the second of two nodes, and one vertex far below on the first.
RiggedMesh ballOnAFoot() {
    RiggedMesh mesh;
    mesh.nodes = {{"leg", -1}, {"foot", 0}};
    mesh.node_of_bone = {0, 1};
    mesh.skin.bones = {{"leg"}, {"foot"}};
    std::mt19937 random(7);
    std::normal_distribution<float> anywhere;
    for (int i = 0; i < 4000; ++i) {
        const Eigen::Vector3f p{anywhere(random), anywhere(random), anywhere(random)};
        mesh.skin.vertices.push_back({0.1F * p.normalized(), p.normalized(), {1, 0}, {1, 0}});
    }
    mesh.skin.vertices.push_back({{0, -5, 0}, Eigen::Vector3f::UnitY(), {0, 1}, {1, 0}});
    return mesh;
}

TEST(FootSkin, TheLowestOfAnyTurnIsAmongItsPoints) {
    const RiggedMesh mesh = ballOnAFoot();
    const auto points = lowestSkin(mesh, {false, true}, Vector3d::UnitY());
    EXPECT_LT(points.size(), 100U);
    for (double turn_deg = -80; turn_deg <= 80; turn_deg += 10)
        for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(0.6, 0, 0.8)}) {
            const Quaterniond q = axisAngle(axis, radians(turn_deg));
            double lowest_m = 1;
            for (const Vector3d& p : points)
                lowest_m = std::min(lowest_m, (q * p).y());
            EXPECT_NEAR(lowest_m, -0.1, 0.0015) << turn_deg;
        }
}

TEST(FootSkin, AFigureThatLiesIsSeenFromItsOwnUp) {
    for (const Vector3d& p : lowestSkin(ballOnAFoot(), {false, true}, Vector3d::UnitZ()))
        EXPECT_LT(p.z(), 0.02);
}

/// Heel and toes on a foot of 0.2 m whose ankle is 0.1 m up.
const std::vector<Vector3d> kFoot{{0, -0.1, -0.05}, {0, -0.1, 0.15}};
const Vector3d kUpwards = -Vector3d::UnitX();  ///< about which a turn lifts the toes

TEST(FootSkin, ToesTurnUpUntilTheyTouchTheFloor) {
    std::vector<Vector3d> pitched;
    for (const Vector3d& p : kFoot)
        pitched.push_back(axisAngle(kUpwards, radians(-30)) * p);
    const double floor_m = -0.13;
    const double turn = turnAboveFloor(pitched, Vector3d::Zero(), kUpwards, floor_m, radians(30));
    EXPECT_GT(turn, radians(5));
    EXPECT_LT(turn, radians(30));
    EXPECT_NEAR((axisAngle(kUpwards, turn) * pitched[1]).y(), floor_m, 1e-4);
}

TEST(FootSkin, WhatIsAboveStaysAndWhatCannotBeIsLiftedAsFarAsItGoes) {
    EXPECT_EQ(turnAboveFloor(kFoot, Vector3d::Zero(), kUpwards, -0.2, radians(30)), 0);
    EXPECT_EQ(turnAboveFloor(kFoot, Vector3d::Zero(), kUpwards, -0.05, 0), 0) << "flat already";
    EXPECT_EQ(turnAboveFloor({}, Vector3d::Zero(), kUpwards, 1, radians(30)), 0);
    std::vector<Vector3d> heel_first;
    for (const Vector3d& p : kFoot)
        heel_first.push_back(axisAngle(kUpwards, radians(20)) * p);
    EXPECT_NEAR(turnAboveFloor(heel_first, Vector3d::Zero(), kUpwards, -0.099, radians(-20)), radians(-20),
                1e-9)
        << "turns down to lie flat, though a millimetre below";
}

}  // namespace
}  // namespace noctule
