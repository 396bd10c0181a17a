// SPDX-License-Identifier: Apache-2.0
// A body moved on the floor: turned about the vertical through the world's origin, then shifted horizontally.
// Heights, tilt and posture stay.
#pragma once

#include "core/body/skeleton.h"

namespace noctule {

/// Angle about the vertical from +Z to where a root faces. Seen from right above or below (lying), its up
/// says more than its forward.
double floorHeading(const Quaterniond& q_world_root);

struct FloorMove {
    double turn_rad = 0;
    Vector3d shift_m = Vector3d::Zero();  ///< its y is 0

    bool operator==(const FloorMove& other) const {
        return turn_rad == other.turn_rad && shift_m == other.shift_m;
    }
};

/// By which the root comes above the origin and faces +Z.
FloorMove moveToOrigin(const Pose& pose);
Pose movedOnFloor(Pose pose, const FloorMove& move);

}  // namespace noctule
