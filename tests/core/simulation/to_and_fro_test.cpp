// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/to_and_fro.h"

#include <cmath>

#include "tests/core/simulation/simulated_body.h"

namespace noctule::simulation {
namespace {

TEST(ToAndFro, TimeGoesForthAndBackWithoutAJump) {
    constexpr double kInstant_s = 1e-4;
    for (const double once_s : {0.7, 3.0, 20.0}) {
        double most = 0, least_after = once_s;
        for (double t_s = kInstant_s; t_s < 5 * once_s + 10; t_s += 0.0113) {
            const PlayedTime before = toAndFro(t_s - kInstant_s, once_s), now = toAndFro(t_s, once_s),
                             after = toAndFro(t_s + kInstant_s, once_s);
            EXPECT_NEAR(now.rate, (after.t_s - before.t_s) / (2 * kInstant_s), 1e-4)
                << once_s << " at " << t_s;
            EXPECT_NEAR(now.acceleration_per_s, (after.rate - before.rate) / (2 * kInstant_s), 1e-2)
                << once_s << " at " << t_s;
            EXPECT_GE(now.t_s, -1e-9);
            EXPECT_LE(now.t_s, once_s + 1e-9);
            most = std::max(most, now.t_s);
            if (t_s > once_s)
                least_after = std::min(least_after, now.t_s);
        }
        EXPECT_NEAR(most, once_s, 0.01) << "to the very end";
        EXPECT_NEAR(least_after, 0, 0.01) << "and back to the beginning";
    }
}

/// Walks 3 m away, four times as long as the motion lasts.
TEST(ToAndFro, WhoComesBackStaysInTheRoomAndIsNeverJerked) {
    BodyWorld world = makeWorld(madeMotion(), Scenario::nominal(), {.rest_seconds = 1});
    const double once_s = world.duration_s();
    const Vector3d end = world.boardMotion(9, once_s).p_world_board_m;
    ASSERT_GT(end.z(), 2);
    world.comeBack(20);
    EXPECT_EQ(world.duration_s(), 20);
    Vector3d before = world.boardMotion(9, 0).accel_m_per_s2;
    double farthest_m = 0, nearest_after_m = 10;
    for (double t_s = 0; t_s < 20; t_s += 1e-3) {
        const BoardMotion now = world.boardMotion(9, t_s);
        EXPECT_LT((now.accel_m_per_s2 - before).norm(), 1.5) << "at " << t_s;
        before = now.accel_m_per_s2;
        farthest_m = std::max(farthest_m, now.p_world_board_m.z());
        if (t_s > once_s)
            nearest_after_m = std::min(nearest_after_m, now.p_world_board_m.z());
    }
    EXPECT_LT(farthest_m, end.z() + 0.7);
    EXPECT_LT(nearest_after_m, 0.7) << "back where the walk began";
    constexpr double kDifference_s = 1e-4;
    for (const double t_s : {once_s - 0.5, once_s + 0.2, once_s + 2.5}) {
        const BoardMotion a = world.boardMotion(9, t_s - kDifference_s),
                          b = world.boardMotion(9, t_s + kDifference_s);
        const Vector3d turned =
            logQuaternion(a.q_world_board.conjugate() * b.q_world_board) / (2 * kDifference_s);
        EXPECT_LT((world.boardMotion(9, t_s).gyro_rad_per_s - turned).norm(), 2e-3) << t_s;
    }
}

}  // namespace
}  // namespace noctule::simulation
