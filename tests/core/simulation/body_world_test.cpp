// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/body_world.h"

#include <gtest/gtest.h>

#include "tests/core/simulation/simulated_body.h"

namespace noctule::simulation {
namespace {

constexpr double kStep_s = 1e-4;

/// Gyroscope and accelerometer of a board from its poses alone, by central differences.
BoardMotion byDifferences(const BodyWorld& world, int board, double t_s) {
    const BoardMotion before = world.boardMotion(board, t_s - kStep_s), at = world.boardMotion(board, t_s),
                      after = world.boardMotion(board, t_s + kStep_s);
    BoardMotion m = at;
    m.gyro_rad_per_s = logQuaternion(before.q_world_board.conjugate() * after.q_world_board) / (2 * kStep_s);
    const Vector3d acceleration =
        (before.p_world_board_m - 2 * at.p_world_board_m + after.p_world_board_m) / (kStep_s * kStep_s);
    m.accel_m_per_s2 =
        at.q_world_board.conjugate() * (acceleration + Vector3d(0, kStandardGravity_m_per_s2, 0));
    return m;
}

void expectRatesOfTrajectories(const Scenario& scenario) {
    const BodyWorld world = makeWorld(madeMotion(), scenario, {.rest_seconds = 1});
    for (int board = 0; board < world.boardCount(); ++board)
        for (double t = 0.35; t < 4.9; t += 0.5037) {
            const BoardMotion exact = world.boardMotion(board, t),
                              differences = byDifferences(world, board, t);
            EXPECT_LT((exact.gyro_rad_per_s - differences.gyro_rad_per_s).norm(), 2e-3)
                << board << " at " << t;
            EXPECT_LT((exact.accel_m_per_s2 - differences.accel_m_per_s2).norm(), 2e-2)
                << board << " at " << t;
        }
}

TEST(BodyWorld, RatesAreThoseOfTheTrajectories) {
    expectRatesOfTrajectories(Scenario::nominal());
}

TEST(BodyWorld, RatesIncludeSoftTissue) {
    expectRatesOfTrajectories(Scenario::realistic());
}

TEST(BodyWorld, TextbookTurntable) {
    // One rigid segment turning at 3 rad/s about the vertical, the board 0.2 m off the axis: 3 rad/s, 9 * 0.2
    // m/s^2 inwards and g upwards.
    Joint root{"Hips", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}};
    const Coordinates coordinates(Skeleton::make({root}).value());
    FittedMotion motion;
    motion.step_s = 1.0 / 240;
    for (int f = 0; f < 960; ++f) {
        const Quaterniond q = axisAngle(Vector3d::UnitY(), 3 * motion.step_s * f);
        std::vector<double> row = coordinates.fromPose({Vector3d::Zero(), {q}});
        if (f > 0)
            coordinates.continueFrom(motion.rows.back(), row);
        motion.rows.push_back(row);
    }
    WornSuit worn;
    worn.boards.push_back({.segment = 0, .p_segment_board_m = {0.2, 0, 0}});
    const BodyWorld world(Performance(coordinates, motion.rows[0], &motion, {.rest_seconds = 0.5}), worn, {},
                          {});
    const BoardMotion m = world.boardMotion(0, 2.5);
    EXPECT_LT((m.gyro_rad_per_s - Vector3d(0, 3, 0)).norm(), 1e-5);
    EXPECT_LT((m.accel_m_per_s2 - Vector3d(-1.8, kStandardGravity_m_per_s2, 0)).norm(), 1e-3);
    const BoardMotion still = world.boardMotion(0, 0.25);
    EXPECT_EQ(still.gyro_rad_per_s, Vector3d::Zero());
    EXPECT_LT((still.accel_m_per_s2 - Vector3d(0, kStandardGravity_m_per_s2, 0)).norm(), 1e-12);
}

TEST(BodyWorld, TabulatedPointsAreExactToAMicrometre) {
    for (const Scenario& scenario : {Scenario::nominal(), Scenario::realistic()}) {
        const BodyWorld world = makeWorld(madeMotion(), scenario, {.rest_seconds = 1});
        for (double t = 0.9; t < 4.9; t += 0.0171)
            for (int b = 0; b < world.boardCount(); b += 3) {
                const BoardMotion board = world.boardMotion(b, t);
                const Vector3d exact =
                    board.p_world_board_m + board.q_world_board * world.worn().boards[b].p_board_mic_m;
                EXPECT_LT((world.microphone(b, t) - exact).norm(), scenario.soft_tissue ? 5e-6 : 1e-6)
                    << scenario.name << ", board " << b << " at " << t;
            }
    }
}

TEST(BodyWorld, GoingBackInTimeGivesTheSameAnswer) {
    const BodyWorld world = makeWorld(madeMotion(12), Scenario::realistic());
    const BodyWorld fresh = makeWorld(madeMotion(12), Scenario::realistic());
    const Vector3d late = world.microphone(3, 13.01);
    const Vector3d early = world.microphone(3, 4.4);
    EXPECT_EQ(early, fresh.microphone(3, 4.4));
    EXPECT_EQ(late, fresh.microphone(3, 13.01));
}

TEST(BodyWorld, AccelerationIsContinuousThroughRestTransitionAndRepetition) {
    const BodyWorld world =
        makeWorld(madeMotion(), Scenario::nominal(), {.rest_seconds = 1, .duration_s = 12});
    EXPECT_EQ(world.duration_s(), 12);
    Vector3d before = world.boardMotion(9, 0).accel_m_per_s2;
    double largest = 0;
    for (double t = 0; t < 12; t += 1e-3) {
        const Vector3d now = world.boardMotion(9, t).accel_m_per_s2;
        EXPECT_LT((now - before).norm(), 1.5) << "at " << t;  // 1500 m/s^3 would be a very hard kick
        largest = std::max(largest, now.norm());
        before = now;
    }
    EXPECT_LT(largest, 60);
}

TEST(BodyWorld, WobbleFollowsTheScenariosNumbers) {
    // A shake far below 12 Hz displaces by the static ratio; measured as world position against the same body
    // without wobble.
    Scenario with = Scenario::nominal(), without = with;
    with.soft_tissue =
        SoftTissue{.pose_rotation_rad_max = 0, .pose_displacement_m_max = 0, .axial_twist_lag = 0};
    const BodyWorld soft = makeWorld(madeMotion(), with), stiff = makeWorld(madeMotion(), without);
    double worst_ratio = 0, acceleration = 0;
    for (double t = 4.5; t < 6.5; t += 0.01) {
        const BoardMotion a = soft.boardMotion(9, t), b = stiff.boardMotion(9, t);
        const Vector3d force =
            b.accel_m_per_s2 - b.q_world_board.conjugate() * Vector3d(0, kStandardGravity_m_per_s2, 0);
        worst_ratio = std::max(worst_ratio, (a.p_world_board_m - b.p_world_board_m).norm());
        acceleration = std::max(acceleration, force.norm());
    }
    EXPECT_NEAR(worst_ratio / acceleration, 0.005 / 30, 0.25 * 0.005 / 30);
}

TEST(BodyWorld, SuitThatNamesAnUnknownSegmentIsRefused) {
    Suit suit = defaultSuit();
    suit.boards[4].segment = "Tail";
    const Result<WornSuit> worn = wear(suit, defaultActor().skeleton, Scenario::ideal(), 1);
    ASSERT_FALSE(worn);
    EXPECT_NE(worn.error().message.find("Tail"), std::string::npos);
}

TEST(BodyWorld, ASlippedBoardHasTurnedAboutTheBoneAndFeltIt) {
    for (const Scenario& scenario : {Scenario::nominal(), Scenario::realistic()}) {
        BodyWorld world = makeWorld(madeMotion(), scenario, {.rest_seconds = 1});
        const BodyWorld firm = makeWorld(madeMotion(), scenario, {.rest_seconds = 1});
        constexpr int kBoard = 9;
        world.microphone(kBoard, 2.2);  // rows of later times exist already
        world.slip(kBoard, 0.4, 2.0);
        for (const double t : {1.9, 2.1, 2.25, 2.4, 2.6, 4.0}) {
            const BoardMotion exact = world.boardMotion(kBoard, t),
                              differences = byDifferences(world, kBoard, t);
            EXPECT_LT((exact.gyro_rad_per_s - differences.gyro_rad_per_s).norm(), 2e-3) << t;
            const Vector3d mic =
                exact.p_world_board_m + exact.q_world_board * world.worn().boards[kBoard].p_board_mic_m;
            EXPECT_LT((world.microphone(kBoard, t) - mic).norm(), 2e-5) << t;
            const double turned =
                exact.q_world_board.angularDistance(firm.boardMotion(kBoard, t).q_world_board);
            EXPECT_NEAR(turned, t <= 2 ? 0 : t >= 2.5 ? 0.4 : turned, 1e-9) << t;
        }
        world.beginAgain();
        EXPECT_NEAR(world.boardMotion(kBoard, 0).q_world_board.angularDistance(
                        firm.boardMotion(kBoard, 0).q_world_board),
                    0.4, 1e-9);
    }
}

TEST(BodyWorld, APoseIsTakenSmoothlyFeltAndKept) {
    const Actor actor = defaultActor();
    const Coordinates coordinates(actor.skeleton);
    const Scenario scenario = Scenario::ideal();
    BodyWorld world(Performance(coordinates, heldRestRow(coordinates, actor, scenario, 1), nullptr,
                                {.rest_seconds = 60, .duration_s = 60}),
                    wear(defaultSuit(), actor.skeleton, scenario, 1).value(), actor.capsules, std::nullopt);
    const int board = defaultSuit().findBoard("l_forearm");
    const Vector3d before = world.microphone(board, 3);
    world.takePose(actor.skeleton.zeroPose(), 1);
    EXPECT_EQ(world.boardMotion(board, 1).gyro_rad_per_s.norm(), 0);
    EXPECT_GT((world.microphone(board, 3) - before).norm(), 0.2) << "arms go up into the T";
    EXPECT_EQ(world.boardMotion(board, 1 + Performance::kPosing_s).gyro_rad_per_s.norm(), 0);
    Quaterniond felt = world.boardMotion(board, 1).q_world_board;
    for (int i = 0; i < 1500; ++i)
        felt = felt * expQuaternion(world.boardMotion(board, 1 + (i + 0.5) * 1e-3).gyro_rad_per_s * 1e-3);
    EXPECT_LT(angleBetween(felt, world.boardMotion(board, 3).q_world_board), 1e-5);
    const Vector3d in_t = world.microphone(board, 3);
    world.beginAgain();
    EXPECT_LT((world.microphone(board, 0) - in_t).norm(), 1e-12);
}

TEST(BodyWorld, FarAheadIsTheSameAsStepByStep) {
    const BodyWorld far = makeWorld(madeMotion(), Scenario::realistic(), {.duration_s = 60});
    const BodyWorld near = makeWorld(madeMotion(), Scenario::realistic(), {.duration_s = 60});
    const Vector3d ahead = far.microphone(9, 50);
    for (double t = 0; t < 50; t += 0.5)
        near.microphone(9, t);
    EXPECT_LT((near.microphone(9, 50) - ahead).norm(), 1e-15);
    EXPECT_LT((near.microphone(9, 48.9) - far.microphone(9, 48.9)).norm(), 1e-15);
}

}  // namespace
}  // namespace noctule::simulation
