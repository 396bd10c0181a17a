// SPDX-License-Identifier: Apache-2.0
// A film of a performer and, to the performer's left, of the robot that follows: the robot's links as
// capsules, its root where it stands.
#pragma once

#include "core/film/film.h"
#include "core/robot/motion_mapping.h"

namespace noctule::robot {

/// The robot at the instants of the clip, clear of the performer's whole way; the last command stays where
/// the clip is longer. `commands` has frames.
FilmCompanion companionOf(const MotionClip& clip, const RobotModel& model, const RobotProfile& profile,
                          const RobotTrajectory& commands);

/// The default body and the robot; a frame of the film per frame of the clip. Errors as writeFilm().
Status writeRobotFilm(const std::string& path, const MotionClip& clip, const RobotModel& model,
                      const RobotProfile& profile, const RobotTrajectory& commands, bool overwrite,
                      const JobContext& job);

}  // namespace noctule::robot
