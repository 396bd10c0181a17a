// SPDX-License-Identifier: Apache-2.0
// Boards in a bag that is rolled: what their magnetometers send, through the boards' own code.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <set>

#include "core/simulation/inertial_sensor.h"
#include "core/simulation/rig_world.h"

namespace noctule::simulation {
namespace {

TEST(RigBag, MagnetometersSeeTheFieldFromAllDirections) {
    Suit suit;
    for (const bool has_magnetometer : {true, true, false}) {
        Board board;
        board.id = "b" + std::to_string(suit.boards.size());
        board.has_magnetometer = has_magnetometer;
        suit.boards.push_back(board);
    }
    Scenario scenario;
    scenario.codec = true;
    constexpr double kRolled_s = 90;
    RigWorld bag(RigKind::kBag, suit, scenario.rigs, 3, kRolled_s);
    EXPECT_NEAR(bag.roll(kRolled_s, 0), kRolled_s, RigWorld::kTurn_s);
    for (int board = 0; board < 3; ++board) {
        const InertialTruth truth = drawInertialTruth(suit.boards[static_cast<size_t>(board)], scenario, 3,
                                                      static_cast<uint64_t>(board));
        ASSERT_EQ(truth.mag.has_value(), board < 2);
        BoardReadings readings(bag, board, truth, scenario, 3);
        int heard = 0;
        std::set<std::array<int, 3>> directions;
        for (int64_t frame = 0; frame < static_cast<int64_t>(kRolled_s * kInertialFramesPerSecond); ++frame) {
            const auto counts = readings.next(frame).magnetometer_counts;
            if (!counts[0] || !counts[1] || !counts[2])
                continue;
            ++heard;
            const Vector3d felt_ut =
                (Vector3d(*counts[0], *counts[1], *counts[2]) - Vector3d::Constant(2048)) * 100 / 2048;
            const Vector3d field_ut = truth.mag->soft.inverse() * (felt_ut - truth.mag->hard_ut);
            EXPECT_NEAR(field_ut.norm(), SuitWorld::kEarthField_ut.norm(), 1.5);
            const Vector3d unit = field_ut.normalized();
            std::array<int, 3> direction{};
            for (int axis = 0; axis < 3; ++axis)
                direction[static_cast<size_t>(axis)] = unit[axis] > 0.4 ? 1 : unit[axis] < -0.4 ? -1 : 0;
            directions.insert(direction);
        }
        EXPECT_EQ(heard > 0, board < 2);
        if (board < 2) {
            EXPECT_NEAR(heard / kRolled_s, 7, 0.2);
            EXPECT_GE(directions.size(), 24u) << "of 26 sides, edges and corners";
        }
    }
}

TEST(RigBag, NearTheFloorTheFieldIsBent) {
    Suit suit;
    suit.boards.resize(4);
    RigWorld bag(RigKind::kBag, suit, {}, 3, 10);
    const Quaterniond before = bag.boardMotion(0, 0).q_world_board;
    const auto stronger = [&](double t_s) {
        const Vector3d at_m = bag.boardMotion(0, t_s).p_world_board_m;
        return bag.field_ut(at_m).norm() / SuitWorld::kEarthField_ut.norm() - 1;
    };
    EXPECT_LT(std::abs(stronger(0)), 0.01);
    EXPECT_NEAR(bag.carryTo(0.15, 1), 1 + RigWorld::kMove_s, 1e-9);
    EXPECT_NEAR(bag.boardMotion(0, 4).p_world_board_m.y(), 0.15, 1e-9);
    EXPECT_NEAR(bag.boardMotion(0, 2).accel_m_per_s2.norm(), kStandardGravity_m_per_s2, 1);
    EXPECT_GT(std::abs(bag.boardMotion(0, 1.5).accel_m_per_s2.norm() - kStandardGravity_m_per_s2), 0.4)
        << "it is felt";
    EXPECT_TRUE(before.isApprox(bag.boardMotion(0, 4).q_world_board));
    EXPECT_GT(stronger(4), 0.1);
    EXPECT_LT(stronger(4), 0.2);
    bag.beginAgain();
    EXPECT_NEAR(bag.boardMotion(0, 0).p_world_board_m.y(), 0.15, 1e-9) << "it stays where it was put";
}

}  // namespace
}  // namespace noctule::simulation
