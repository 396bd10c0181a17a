// SPDX-License-Identifier: Apache-2.0
// A performer's motion as commands of a robot: one posture of all driven joints per frame.
#pragma once

#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/motion/clip.h"
#include "core/robot/profile.h"

namespace noctule::robot {

enum class Mapping {
    kPosture,      ///< posture and scaled wrist (arm_follower.h)
    kMiller,       ///< Miller 2004 with two sensors: in the world's axes
    kMillerTrunk,  ///< the same with a third sensor on the trunk
};

struct MappingChoice {
    Mapping mapping = Mapping::kPosture;
    bool left = true, right = true;  ///< which of the profile's arms
    bool trunk = false;              ///< the robot's waist follows the performer's
    bool legs = false;  ///< so do both legs; feet that stand keep their place (RobotTrajectory::root)
};

/// Over all frames of one arm or leg; of a leg thigh, shank and ankle.
struct ArmFigures {
    std::string arm;
    double upper_mean_deg = 0, upper_max_deg = 0;
    double forearm_mean_deg = 0, forearm_max_deg = 0;
    double wrist_mean_mm = 0, wrist_max_mm = 0;
    int limited_frames = 0;  ///< a limit of motion held a joint back
};

struct RobotTrajectory {
    double frame_time_s = 0;
    std::vector<std::string> joints;
    std::vector<std::vector<double>> frames;  ///< per frame one value per joint, rad or m
    std::vector<ArmFigures> arms;
    std::vector<ArmFigures> legs;
    /// With legs, per frame: where the root link would be in the performer's world, which is as much smaller
    /// or larger as the legs are. There a foot stands still when the performer's does. A robot that balances
    /// chooses its root itself.
    std::vector<Eigen::Isometry3d> root;
    int held_frames = 0;        ///< the robot's own parts would have come too near
    std::string nearest_parts;  ///< which, at their nearest
    double nearest_m = 0;
    std::vector<double> loop_start_s;  ///< where playback returns to the beginning; at most one
};

/// The limits that the commands keep, by joint of a trajectory. 0: none.
struct CommandLimits {
    double lower = 0, upper = 0, speed = 0, acceleration = 0, jerk = 0;
};
Result<std::vector<CommandLimits>> limitsOf(const RobotModel& model, const RobotProfile& profile,
                                            const RobotTrajectory& trajectory);

/// The largest part of a limit that any step uses; beyond 1 a limit is broken. Place: 1 inside.
struct LimitUse {
    double place = 0, speed = 0, acceleration = 0, jerk = 0;
    std::string joint;  ///< of the largest
};
LimitUse limitUse(const RobotTrajectory& trajectory, const std::vector<CommandLimits>& limits);

/// kUnusable when the motion has no frames or no arms, or the profile does not fit the robot or the choice.
Result<RobotTrajectory> mapMotion(const MotionClip& clip, const RobotModel& model,
                                  const RobotProfile& profile, const MappingChoice& choice,
                                  const JobContext& job = {});

/// Goes back from the last frame to the first, so that playback may go on without end: a quintic that meets
/// place and speed at both, as long as the limits need and `shortest_s` at least.
Status closeLoop(RobotTrajectory& trajectory, const std::vector<CommandLimits>& limits,
                 double shortest_s = 1);

}  // namespace noctule::robot
