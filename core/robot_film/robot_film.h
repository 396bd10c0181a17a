// SPDX-License-Identifier: Apache-2.0
// A film of a performer and, to the performer's left, of the robot that follows.
#pragma once

#include "core/film/film.h"
#include "core/robot/motion_mapping.h"

namespace noctule::robot {

/// `mesh` (robot_mesh.h) at the instants of the clip, clear of the performer's whole way; the last command
/// stays where the clip is longer. `commands` has frames.
FilmCompanion companionOf(const MotionClip& clip, const RobotModel& model, const RobotProfile& profile,
                          std::shared_ptr<const SkinnedMesh> mesh, const RobotTrajectory& commands);

/// The default body and the robot, turned to the camera; a frame of the film per frame of the clip. Errors as
/// writeFilm().
Status writeRobotFilm(const std::string& path, MotionClip clip, const RobotModel& model,
                      const RobotProfile& profile, std::shared_ptr<const SkinnedMesh> mesh,
                      RobotTrajectory commands, bool overwrite, const JobContext& job);

}  // namespace noctule::robot
