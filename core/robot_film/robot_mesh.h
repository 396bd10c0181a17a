// SPDX-License-Identifier: Apache-2.0
// A robot's links as one mesh, a bone per link, and where the bones are for joint values: capsules, or the
// meshes that its URDF names. In the studio's world its z is up, and its chest looks along Z as a performer's
// does.
#pragma once

#include "core/job/job.h"
#include "core/mesh/skinned_mesh.h"
#include "core/robot/link_shapes.h"
#include "core/robot/profile.h"

namespace noctule::robot {

/// Links without a shape have no bone: the lines between their joints are drawn in the profile's radius.
std::shared_ptr<const SkinnedMesh> meshOf(const RobotModel& model, const RobotProfile& profile);

struct RobotLook {
    std::shared_ptr<const SkinnedMesh> mesh;
    std::vector<std::string> notices;  ///< which meshes are missing or cannot be read, one sentence each
};
/// The links' own meshes where their files are found, read apart (mesh_reader.h); capsules for the others.
/// package://NAME/PATH is looked for in the folders above the URDF, as NAME/PATH and as PATH.
RobotLook lookOf(const RobotModel& model, const RobotProfile& profile, const std::string& urdf_path,
                 const JobContext& job = {});

/// Its root `lift_m` above the middle of the world, facing as a performer who stands there.
Eigen::Isometry3d standingRoot(const RobotModel& model, const RobotProfile& profile, double lift_m);

/// Per bone of meshOf().
std::vector<Eigen::Matrix4f> skinOf(const RobotModel& model, const SkinnedMesh& mesh,
                                    const JointValues& values, const Eigen::Isometry3d& T_world_root);

/// What the mesh fills.
Eigen::AlignedBox3d boxOf(const RobotModel& model, const RobotProfile& profile, const JointValues& values,
                          const Eigen::Isometry3d& T_world_root);

}  // namespace noctule::robot
