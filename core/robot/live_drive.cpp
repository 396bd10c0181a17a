// SPDX-License-Identifier: Apache-2.0
#include "core/robot/live_drive.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "core/math/rotation.h"

namespace noctule::robot {
namespace {

constexpr double kSure_rad = 0.1, kUnsure_rad = 0.6;

void raise(DriveOutput& output, DriveTrouble trouble, const std::string& about = {}, double off_rad = 0) {
    if (trouble >= output.trouble)
        return;
    output.trouble = trouble;
    output.about = about;
    output.off_rad = off_rad;
}

TeleopSettings settingsFor(const RobotArm& arm, double human_length_m, const DriveSettings& settings) {
    TeleopSettings made = settings.teleop;
    made.R_base_world = arm.profile.R_base_body;
    made.scale *= arm.length_m / human_length_m;
    return made;
}

bool isEngaged(TeleopState state) {
    return state == TeleopState::kSynchronising || state == TeleopState::kBlending ||
           state == TeleopState::kFollowing;
}

}  // namespace

double confidenceFor(double sigma_rad) {
    return std::clamp((kUnsure_rad - sigma_rad) / (kUnsure_rad - kSure_rad), 0.0, 1.0);
}

const char* troubleName(DriveTrouble trouble) {
    switch (trouble) {
        case DriveTrouble::kRobotSilent:
            return "robot-silent";
        case DriveTrouble::kRobotRefuses:
            return "robot-refuses";
        case DriveTrouble::kJointOff:
            return "joint-off";
        case DriveTrouble::kNoPose:
            return "no-pose";
        case DriveTrouble::kTooFar:
            return "too-far";
        case DriveTrouble::kTooNear:
            return "too-near";
        case DriveTrouble::kUncertain:
            return "uncertain";
        case DriveTrouble::kOutsideBox:
            return "outside-box";
        case DriveTrouble::kNone:
            break;
    }
    return "";
}

std::string sentenceFor(const DriveOutput& output) {
    char degrees_off[60];
    std::snprintf(degrees_off, sizeof degrees_off, "%.0f degrees", degrees(output.off_rad));
    switch (output.trouble) {
        case DriveTrouble::kRobotSilent:
            return "The robot does not answer; it is told to hold. Check its program and the network.";
        case DriveTrouble::kRobotRefuses:
            return "The robot refuses: the command is too far from where it is. Commands go back to it; "
                   "then engage again.";
        case DriveTrouble::kJointOff:
            return "Joint " + output.about + " is " + degrees_off +
                   " from its command. Commands go back to where the robot is; check the joint, then engage "
                   "again.";
        case DriveTrouble::kNoPose:
            return "No fresh pose of the performer; the robot holds. Check the suit.";
        case DriveTrouble::kTooFar:
            return "Joint " + output.about + " is " + degrees_off +
                   " from the performer; bring the arm nearer to the robot's posture.";
        case DriveTrouble::kTooNear:
            return output.about + " would come too near; the arms brake. Move them apart.";
        case DriveTrouble::kUncertain:
            return "The pose is uncertain; the robot moves slowly.";
        case DriveTrouble::kOutsideBox:
            return "The hand leaves the robot's workspace; the robot stays at its border.";
        case DriveTrouble::kNone:
            break;
    }
    return "";
}

Result<std::vector<RobotArm>> drivenArms(const RobotModel& model, const RobotProfile& profile,
                                         const MappingChoice& choice) {
    std::vector<RobotArm> arms;
    std::set<std::string> joints;
    for (const ArmProfile& wanted : profile.arms) {
        if (wanted.side == Side::kLeft ? !choice.left : !choice.right)
            continue;
        auto arm = makeArm(model, wanted);
        if (!arm)
            return arm.error();
        for (const ChainJoint& joint : arm->chain.joints())
            if (!joints.insert(joint.name).second)
                return Error{
                    ErrorKind::kUnusable,
                    "robot " + profile.robot + ": joint \"" + joint.name + "\" belongs to two arms",
                    "Let the base of both arms lie above what they share, or choose one with --arms"};
        arms.push_back(std::move(*arm));
    }
    if (arms.empty())
        return Error{ErrorKind::kUnusable, "robot " + profile.robot + " has no arm on the side asked for",
                     "Choose another with --arms"};
    return arms;
}

std::vector<std::string> jointsOf(const std::vector<RobotArm>& arms) {
    std::vector<std::string> joints;
    for (const RobotArm& arm : arms)
        for (const ChainJoint& joint : arm.chain.joints())
            joints.push_back(joint.name);
    return joints;
}

LiveDrive::Arm::Arm(const RobotArm& robot_arm, const RobotProfile& profile, double human_length_m,
                    const DriveSettings& settings, const JointVector& q)
    : ghost(robot_arm, profile, human_length_m, settings.teleop.dt_s),
      teleoperator(robot_arm, profile, settingsFor(robot_arm, human_length_m, settings), q),
      first(0) {}

LiveDrive::LiveDrive(const RobotModel& model, const RobotProfile& profile, const std::vector<RobotArm>& arms,
                     const std::array<double, 2>& human_length_m, const DriveSettings& settings,
                     const std::vector<double>& q)
    : model_(model),
      settings_(settings),
      clearance_m_(profile.clearance_m),
      joints_(jointsOf(arms)),
      last_near_m_(std::numeric_limits<double>::infinity()),
      last_q_(q) {
    require(q.size() == joints_.size(), "the robot's state has every driven joint");
    JointValues reference;
    size_t first = 0;
    for (const RobotArm& arm : arms) {
        JointVector place(arm.chain.size());
        for (int i = 0; i < arm.chain.size(); ++i) {
            place[i] = q[first + static_cast<size_t>(i)];
            reference[arm.chain.joint(i).model_joint] = arm.reference[i];
        }
        arms_.emplace_back(arm, profile, human_length_m[static_cast<size_t>(arm.profile.side)], settings,
                           place);
        arms_.back().first = first;
        first += static_cast<size_t>(arm.chain.size());
    }
    collision_ = std::make_unique<SelfCollision>(model, profile, reference);
}

/// A robot that does not do as it is told is no longer driven until commands and robot are together again.
void LiveDrive::lookAt(const DriveInput& input, DriveOutput& output) {
    const bool is_silent =
        !input.robot || input.robot->q.size() != joints_.size() ||
        static_cast<double>(input.now_ns - input.robot->arrived_ns) * 1e-9 > settings_.robot_stale_s;
    if (is_silent) {
        off_since_ns_ = 0;
        raise(output, DriveTrouble::kRobotSilent);
        return;
    }
    size_t farthest = 0;
    double off_rad = 0;
    for (size_t i = 0; i < joints_.size(); ++i)
        if (const double off = std::abs(last_q_[i] - input.robot->q[i]); !(off <= off_rad)) {
            off_rad = off;
            farthest = i;
        }
    if (off_rad <= settings_.off_rad)
        off_since_ns_ = 0;
    else if (off_since_ns_ == 0)
        off_since_ns_ = input.now_ns;
    const bool is_off =
        off_since_ns_ != 0 && static_cast<double>(input.now_ns - off_since_ns_) * 1e-9 >= settings_.off_s;
    recovers_ |= is_off || input.robot->refuses;
    if (recovers_ && !input.robot->refuses && off_rad <= settings_.off_rad / 2)
        recovers_ = false;
    if (recovers_)
        raise(output, input.robot->refuses ? DriveTrouble::kRobotRefuses : DriveTrouble::kJointOff,
              joints_[farthest], off_rad);
}

std::optional<TeleopPose> LiveDrive::poseFor(Arm& arm, const DriveInput& input) {
    if (!input.performer)
        return std::nullopt;
    const ArmPose& seen = input.performer->frame.in_chest[static_cast<size_t>(arm.ghost.arm().profile.side)];
    TeleopPose pose;
    pose.time_ns = input.performer->arrived_ns;
    pose.confidence = input.performer->confidence;
    pose.p_world_hand = seen.wrist_m;
    pose.q_world_hand = Quaterniond(seen.R_hand);
    if (settings_.follows_posture) {
        if (!has_settled_)
            arm.ghost.settle(seen);
        pose.posture = arm.ghost.follow(seen).q;
    }
    return pose;
}

void LiveDrive::stepArms(const DriveInput& input, DriveOutput& output) {
    const bool is_blocked = output.trouble == DriveTrouble::kRobotSilent || recovers_;
    TeleopKeys keys = input.keys;
    keys.clutch &= !is_blocked;
    keys.accept &= all_near_;
    all_near_ = true;
    for (Arm& arm : arms_) {
        const int size = arm.ghost.arm().chain.size();
        std::optional<JointVector> retreat;
        if (recovers_ && output.trouble != DriveTrouble::kRobotSilent) {
            retreat.emplace(size);
            for (int i = 0; i < size; ++i)
                (*retreat)[i] = input.robot->q[arm.first + static_cast<size_t>(i)];
        }
        arm.teleoperator.setRetreat(retreat);
        const TeleopCommand command = arm.teleoperator.step(input.now_ns, poseFor(arm, input), keys);
        output.state = command.state;
        for (int i = 0; i < size; ++i)
            output.ghost.push_back(command.ghost[i]);
        if (command.state == TeleopState::kLost || (input.keys.clutch && command.state == TeleopState::kIdle))
            raise(output, DriveTrouble::kNoPose);
        const bool is_near = command.farthest_rad <= settings_.teleop.farthest_rad;
        all_near_ &= is_near;
        if (command.state == TeleopState::kSynchronising && !is_near)
            raise(output, DriveTrouble::kTooFar,
                  joints_[arm.first + static_cast<size_t>(command.farthest_joint)], command.farthest_rad);
        if (isEngaged(command.state) && command.is_slowed)
            raise(output, DriveTrouble::kUncertain);
        if (isEngaged(command.state) && command.is_outside_box)
            raise(output, DriveTrouble::kOutsideBox);
    }
    has_settled_ |= input.performer.has_value();
}

JointValues LiveDrive::valuesNow() const {
    JointValues values;
    for (const Arm& arm : arms_)
        for (size_t i = 0; i < arm.teleoperator.motion().size(); ++i)
            values[arm.ghost.arm().chain.joint(static_cast<int>(i)).model_joint] =
                arm.teleoperator.motion()[i].place;
    return values;
}

void LiveDrive::keepApart(const std::vector<std::vector<JointMotion>>& before, DriveOutput& output) {
    if (clearance_m_ <= 0)
        return;
    auto near = collision_->nearest(valuesNow());
    if (near.distance_m < clearance_m_ && near.distance_m < last_near_m_) {
        raise(output, DriveTrouble::kTooNear,
              model_.links[static_cast<size_t>(near.link_a)].name + " and " +
                  model_.links[static_cast<size_t>(near.link_b)].name);
        for (size_t i = 0; i < arms_.size(); ++i)
            arms_[i].teleoperator.brakeFrom(before[i]);
        near = collision_->nearest(valuesNow());
    }
    last_near_m_ = near.distance_m;
}

void LiveDrive::write(DriveOutput& output) const {
    for (const Arm& arm : arms_)
        for (const JointMotion& motion : arm.teleoperator.motion())
            output.q.push_back(motion.place);
    for (size_t i = 0; i < output.q.size(); ++i)
        output.v.push_back((output.q[i] - last_q_[i]) / settings_.teleop.dt_s);
}

DriveOutput LiveDrive::step(const DriveInput& input) {
    DriveOutput output;
    lookAt(input, output);
    std::vector<std::vector<JointMotion>> before;
    for (const Arm& arm : arms_)
        before.push_back(arm.teleoperator.motion());
    stepArms(input, output);
    keepApart(before, output);
    write(output);
    last_q_ = output.q;
    return output;
}

}  // namespace noctule::robot
