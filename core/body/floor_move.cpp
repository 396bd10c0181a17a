// SPDX-License-Identifier: Apache-2.0
#include "core/body/floor_move.h"

#include <cmath>

#include "core/math/rotation.h"

namespace noctule {

double floorHeading(const Quaterniond& q_world_root) {
    const Vector3d forward = q_world_root * Vector3d::UnitZ();
    const Vector3d facing = std::hypot(forward.x(), forward.z()) > 0.1
                                ? forward
                                : Vector3d(q_world_root * Vector3d::UnitY() * -forward.y());
    return std::atan2(facing.x(), facing.z());
}

FloorMove moveToOrigin(const Pose& pose) {
    FloorMove move{-floorHeading(pose.q_parent_joint[0]), Vector3d::Zero()};
    move.shift_m = -(axisAngle(Vector3d::UnitY(), move.turn_rad) * pose.p_world_root);
    move.shift_m.y() = 0;
    return move;
}

Pose movedOnFloor(Pose pose, const FloorMove& move) {
    const Quaterniond turn = axisAngle(Vector3d::UnitY(), move.turn_rad);
    const double height_m = pose.p_world_root.y();
    pose.p_world_root = turn * pose.p_world_root + move.shift_m;
    pose.p_world_root.y() = height_m;  // to the bit
    pose.q_parent_joint[0] = turn * pose.q_parent_joint[0];
    return pose;
}

}  // namespace noctule
