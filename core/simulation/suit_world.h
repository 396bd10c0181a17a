// SPDX-License-Identifier: Apache-2.0
// A world with a suit in it, worn or on a rig: besides the sound also what every board feels.
#pragma once

#include "core/simulation/coordinates.h"
#include "core/simulation/world.h"

namespace noctule::simulation {

/// What a perfect board measures, in its own frame.
struct BoardMotion {
    Quaterniond q_world_board = Quaterniond::Identity();
    Vector3d p_world_board_m = Vector3d::Zero();
    Vector3d gyro_rad_per_s = Vector3d::Zero();
    Vector3d accel_m_per_s2 = Vector3d::Zero();  ///< specific force: acceleration minus gravity
};

/// Of a board that moves so.
BoardMotion motionOf(const Frame<Jet>& board);

class SuitWorld : public World {
public:
    /// The Earth's field where nothing bends it: 48 uT, 65 degrees below the horizon.
    static const Vector3d kEarthField_ut;

    virtual BoardMotion boardMotion(int board, double t_s) const = 0;
    virtual Vector3d field_ut(const Vector3d& /*p_world_m*/) const { return kEarthField_ut; }
    /// Time is 0 again; what was changed on the way stays as it is: a strap that slipped, a plate that was
    /// turned.
    virtual void beginAgain() = 0;
};

}  // namespace noctule::simulation
