// SPDX-License-Identifier: Apache-2.0
// Where the links of a robot stand, and their shapes as capsules: the primitive collision shapes of the URDF,
// or for links without any the lines between their joints.
#pragma once

#include <map>

#include "core/robot/robot_model.h"

namespace noctule::robot {

/// By joint of the model; those that are absent stay at 0.
using JointValues = std::map<int, double>;

/// Of each link, in the root link's frame. Joints that mimic others follow them.
std::vector<Eigen::Isometry3d> linkPlaces(const RobotModel& model, const JointValues& values);

/// In the link's frame. `radius_m`: of lines between joints.
std::vector<LinkShape> shapesOf(const RobotModel& model, size_t link, double radius_m);

}  // namespace noctule::robot
