// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/suit_world.h"

namespace noctule::simulation {

const Vector3d SuitWorld::kEarthField_ut{20, -43.6, 0};

BoardMotion motionOf(const Frame<Jet>& board) {
    const Matrix3d r = board.r.unaryExpr([](const Jet& j) { return j.value; });
    const Matrix3d r_rate = board.r.unaryExpr([](const Jet& j) { return j.rate; });
    const Matrix3d spin = r.transpose() * r_rate;  // [omega]x in the board's frame
    BoardMotion motion;
    motion.q_world_board = Quaterniond(r);
    motion.p_world_board_m = values(board.p);
    motion.gyro_rad_per_s = {(spin(2, 1) - spin(1, 2)) / 2, (spin(0, 2) - spin(2, 0)) / 2,
                             (spin(1, 0) - spin(0, 1)) / 2};
    motion.accel_m_per_s2 =
        r.transpose() * (accelerations(board.p) + Vector3d(0, kStandardGravity_m_per_s2, 0));
    return motion;
}

}  // namespace noctule::simulation
