// SPDX-License-Identifier: Apache-2.0
// A robot's links as one mesh of capsules, a bone per link, and where the bones are for joint values. The
// robot's root stands in the studio's world: its x ahead is Z, its y to the left is X, its z up is Y.
#pragma once

#include "core/mesh/skinned_mesh.h"
#include "core/robot/link_shapes.h"
#include "core/robot/profile.h"

namespace noctule::robot {

Matrix3d worldOfRobot();

/// Links without a shape have no bone: the lines between their joints are drawn in the profile's radius.
std::shared_ptr<const SkinnedMesh> meshOf(const RobotModel& model, const RobotProfile& profile);

/// Its root `lift_m` above the middle of the world, facing as a performer who stands there.
Eigen::Isometry3d standingRoot(double lift_m);

/// Per bone of meshOf().
std::vector<Eigen::Matrix4f> skinOf(const RobotModel& model, const SkinnedMesh& mesh,
                                    const JointValues& values, const Eigen::Isometry3d& T_world_root);

/// What the mesh fills.
Eigen::AlignedBox3d boxOf(const RobotModel& model, const RobotProfile& profile, const JointValues& values,
                          const Eigen::Isometry3d& T_world_root);

}  // namespace noctule::robot
