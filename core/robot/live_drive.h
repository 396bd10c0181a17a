// SPDX-License-Identifier: Apache-2.0
// Drives the arms of a robot live, and its trunk: maps the newest pose, lets a Teleoperator per part decide,
// holds when the robot is silent, refuses or does not follow, keeps its parts apart. Called once per command,
// at equal steps.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "core/robot/arm_follower.h"
#include "core/robot/driven_parts.h"
#include "core/robot/self_collision.h"
#include "core/robot/teleoperation.h"

namespace noctule::robot {

struct DriveSettings {
    TeleopSettings teleop;  ///< R_base_world and scale are set per arm; scale multiplies the arms' ratio
    /// Of the arms; false: the hand, relative to where it engaged. A trunk always follows the posture.
    bool follows_posture = true;
    double robot_stale_s = 0.1;  ///< without a state for so long the robot counts as silent
    double off_rad = 0.35;       ///< between command and state; a robot may lag by latency times speed
    double off_s = 0.3;          ///< so long before it counts
};

struct PerformerSeen {
    int64_t arrived_ns = 0;  ///< of the data that made the pose, on the clock of step()
    PerformerFrame frame;
    double confidence = 1, trunk_confidence = 1;  ///< 0..1; the first of the arms
};

struct RobotSeen {
    int64_t arrived_ns = 0;
    std::vector<double> q;  ///< in the order of the parts' joints
    bool refuses = false;
};

struct DriveInput {
    int64_t now_ns = 0;
    std::optional<PerformerSeen> performer;  ///< the newest, also when it is the same as before
    std::optional<RobotSeen> robot;
    TeleopKeys keys;
};

/// Why the robot does not do what the performer does. Earlier ones hide later ones.
enum class DriveTrouble {
    kRobotSilent,
    kRobotRefuses,
    kJointOff,    ///< `about` does not follow its commands
    kNoPose,      ///< none, or none that is fresh
    kTooFar,      ///< `about` is too far from the performer to be accepted
    kTooNear,     ///< parts of the robot would touch
    kUncertain,   ///< the pose's confidence is low: slowed
    kOutsideBox,  ///< the performer asks for a place outside of the workspace
    kNone,
};

struct DriveOutput {
    std::vector<double> q, v;  ///< in the order of the parts' joints
    std::vector<double> ghost;
    TeleopState state = TeleopState::kIdle;
    DriveTrouble trouble = DriveTrouble::kNone;
    std::string about;   ///< a joint, or two links
    double off_rad = 0;  ///< of kTooFar and kJointOff
};

/// As tables and takes name it: "robot-silent"; empty for kNone.
const char* troubleName(DriveTrouble trouble);
/// One sentence for the operator; empty for kNone.
std::string sentenceFor(const DriveOutput& output);

/// 1 up to 0.1 rad of standard deviation, 0 from 0.6 rad on.
double confidenceFor(double sigma_rad);

class LiveDrive {
public:
    /// `model` must outlive it. `human_length_m` by Side; `q`: where the robot stands, in the order of
    /// the parts' joints.
    LiveDrive(const RobotModel& model, const RobotProfile& profile, const DrivenParts& parts,
              const std::array<double, 2>& human_length_m, const DriveSettings& settings,
              const std::vector<double>& q);

    DriveOutput step(const DriveInput& input);

private:
    using Ghost = std::variant<ArmFollower, TrunkFollower>;
    struct Part {
        Ghost ghost;
        Teleoperator teleoperator;
        size_t first, size;  ///< of its joints in joints_
        const Chain& chain() const;
    };
    void add(Ghost ghost, const Chain& chain, const std::vector<double>& max_speed,
             const RobotProfile& profile, const TeleopSettings& settings, const std::vector<double>& q);
    void lookAt(const DriveInput& input, DriveOutput& output);
    std::optional<TeleopPose> poseFor(Part& part, const DriveInput& input) const;
    TeleopPose armPose(ArmFollower& ghost, const PerformerSeen& seen) const;
    TeleopPose trunkPose(TrunkFollower& ghost, const PerformerSeen& seen) const;
    void stepParts(const DriveInput& input, DriveOutput& output);
    void keepApart(const std::vector<std::vector<JointMotion>>& before, DriveOutput& output);
    JointValues valuesNow() const;
    void write(DriveOutput& output) const;

    const RobotModel& model_;
    DriveSettings settings_;
    double clearance_m_;
    std::vector<Part> parts_;
    std::vector<std::string> joints_;
    std::unique_ptr<SelfCollision> collision_;
    double last_near_m_;
    std::vector<double> last_q_;
    int64_t off_since_ns_ = 0;  ///< 0: no joint is off
    bool recovers_ = false;     ///< the commands go back to where the robot is
    bool all_near_ = false;     ///< every part may be accepted
    bool has_settled_ = false;
};

}  // namespace noctule::robot
