// SPDX-License-Identifier: Apache-2.0
// A page about how a hand followed: two paths against each other in three views (Miller 2004, figure 9), with
// a table of delay and what remains after it. HTML with drawings inside; needs no other file.
#pragma once

#include <string>
#include <utility>

#include "core/motion/clip.h"
#include "core/robot/motion_mapping.h"
#include "core/robot/tracking.h"

namespace noctule::robot {

/// Both in metres in the axes of the chest (x left, y up, z ahead).
struct HandPair {
    std::string arm;
    std::vector<PathPoint> wanted, reached;
};

struct RobotReport {
    std::string title, about;
    std::string wanted_name, reached_name;  ///< "commanded", "achieved"
    std::vector<HandPair> hands;
    std::vector<std::pair<std::string, std::string>> facts;  ///< further rows: name, value
};

std::string reportHtml(const RobotReport& report);

/// Of each arm of the trajectory: the performer's wrist from the shoulder, in the robot's size, and where the
/// commands bring the robot's. `trajectory` comes from mapMotion() of the same motion, robot and choice.
Result<std::vector<HandPair>> wristsOf(const MotionClip& clip, const RobotModel& model,
                                       const RobotProfile& profile, const MappingChoice& choice,
                                       const RobotTrajectory& trajectory);

/// Where the tip of an arm is for values of its joints, in the axes of the chest. `first`: of the arm's
/// joints among `q`.
Vector3d tipInChest(const RobotArm& arm, const std::vector<double>& q, size_t first);

}  // namespace noctule::robot
