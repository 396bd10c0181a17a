// SPDX-License-Identifier: Apache-2.0
#include "core/robot/live_drive.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

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

const Chain& LiveDrive::Part::chain() const {
    const auto* arm = std::get_if<ArmFollower>(&ghost);
    return arm ? arm->arm().chain : std::get<TrunkFollower>(ghost).trunk().chain;
}

LiveDrive::LiveDrive(const RobotModel& model, const RobotProfile& profile, const DrivenParts& parts,
                     const std::array<double, 2>& human_length_m, const DriveSettings& settings,
                     const std::vector<double>& q)
    : model_(model),
      settings_(settings),
      clearance_m_(profile.clearance_m),
      joints_(parts.joints()),
      last_near_m_(std::numeric_limits<double>::infinity()),
      last_q_(q) {
    require(q.size() == joints_.size(), "the robot's state has every driven joint");
    const double dt_s = settings.teleop.dt_s;
    for (const RobotArm& arm : parts.arms) {
        const double human_m = human_length_m[static_cast<size_t>(arm.profile.side)];
        add(ArmFollower(arm, profile, human_m, dt_s), arm.chain, arm.profile.max_speed, profile,
            settingsFor(arm, human_m, settings), q);
    }
    if (parts.trunk) {
        TeleopSettings of_trunk = settings.teleop;  // the workspace is the hands'
        of_trunk.box_min_m = TeleopSettings().box_min_m, of_trunk.box_max_m = TeleopSettings().box_max_m;
        add(TrunkFollower(*parts.trunk, profile, dt_s), parts.trunk->chain, parts.trunk->max_speed, profile,
            of_trunk, q);
    }
    JointValues reference;
    const std::vector<double> values = parts.reference();
    for (const Part& part : parts_)
        for (size_t i = 0; i < part.size; ++i)
            reference[part.chain().joint(static_cast<int>(i)).model_joint] = values[part.first + i];
    collision_ = std::make_unique<SelfCollision>(model, profile, reference);
}

void LiveDrive::add(Ghost ghost, const Chain& chain, const std::vector<double>& max_speed,
                    const RobotProfile& profile, const TeleopSettings& settings,
                    const std::vector<double>& q) {
    const size_t first = parts_.empty() ? 0 : parts_.back().first + parts_.back().size;
    JointVector place(chain.size());
    for (int i = 0; i < chain.size(); ++i)
        place[i] = q[first + static_cast<size_t>(i)];
    parts_.push_back({std::move(ghost), Teleoperator(chain, max_speed, profile, settings, place), first,
                      static_cast<size_t>(chain.size())});
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

TeleopPose LiveDrive::armPose(ArmFollower& ghost, const PerformerSeen& performer) const {
    const ArmPose& seen = performer.frame.in_chest[static_cast<size_t>(ghost.arm().profile.side)];
    TeleopPose pose;
    pose.p_world_hand = seen.wrist_m;
    pose.q_world_hand = Quaterniond(seen.R_hand);
    if (settings_.follows_posture) {
        if (!has_settled_)
            ghost.settle(seen);
        pose.posture = ghost.follow(seen).q;
    }
    return pose;
}

TeleopPose LiveDrive::trunkPose(TrunkFollower& ghost, const PerformerSeen& performer) const {
    if (!has_settled_)
        ghost.settle(performer.frame.R_hips_chest);
    ghost.follow(performer.frame.R_hips_chest);
    TeleopPose pose;
    pose.posture = ghost.places();
    return pose;
}

std::optional<TeleopPose> LiveDrive::poseFor(Part& part, const DriveInput& input) const {
    if (!input.performer)
        return std::nullopt;
    auto* arm = std::get_if<ArmFollower>(&part.ghost);
    TeleopPose pose = arm ? armPose(*arm, *input.performer)
                          : trunkPose(std::get<TrunkFollower>(part.ghost), *input.performer);
    pose.time_ns = input.performer->arrived_ns;
    pose.confidence = arm ? input.performer->confidence : input.performer->trunk_confidence;
    return pose;
}

void LiveDrive::stepParts(const DriveInput& input, DriveOutput& output) {
    const bool is_blocked = output.trouble == DriveTrouble::kRobotSilent || recovers_;
    TeleopKeys keys = input.keys;
    keys.clutch &= !is_blocked;
    keys.accept &= all_near_;
    all_near_ = true;
    for (Part& part : parts_) {
        std::optional<JointVector> retreat;
        if (recovers_ && output.trouble != DriveTrouble::kRobotSilent)
            retreat = JointVector(Eigen::Map<const Eigen::VectorXd>(&input.robot->q[part.first],
                                                                    static_cast<Eigen::Index>(part.size)));
        part.teleoperator.setRetreat(retreat);
        const TeleopCommand command = part.teleoperator.step(input.now_ns, poseFor(part, input), keys);
        output.state = command.state;
        output.ghost.insert(output.ghost.end(), command.ghost.begin(), command.ghost.end());
        if (command.state == TeleopState::kLost || (input.keys.clutch && command.state == TeleopState::kIdle))
            raise(output, DriveTrouble::kNoPose);
        const bool is_near = command.farthest_rad <= settings_.teleop.farthest_rad;
        all_near_ &= is_near;
        if (command.state == TeleopState::kSynchronising && !is_near)
            raise(output, DriveTrouble::kTooFar,
                  joints_[part.first + static_cast<size_t>(command.farthest_joint)], command.farthest_rad);
        if (isEngaged(command.state) && command.is_slowed)
            raise(output, DriveTrouble::kUncertain);
        if (isEngaged(command.state) && command.is_outside_box)
            raise(output, DriveTrouble::kOutsideBox);
    }
    has_settled_ |= input.performer.has_value();
}

JointValues LiveDrive::valuesNow() const {
    JointValues values;
    for (const Part& part : parts_)
        for (size_t i = 0; i < part.size; ++i)
            values[part.chain().joint(static_cast<int>(i)).model_joint] = part.teleoperator.motion()[i].place;
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
        for (size_t i = 0; i < parts_.size(); ++i)
            parts_[i].teleoperator.brakeFrom(before[i]);
        near = collision_->nearest(valuesNow());
    }
    last_near_m_ = near.distance_m;
}

void LiveDrive::write(DriveOutput& output) const {
    for (const Part& part : parts_)
        for (const JointMotion& motion : part.teleoperator.motion())
            output.q.push_back(motion.place);
    for (size_t i = 0; i < output.q.size(); ++i)
        output.v.push_back((output.q[i] - last_q_[i]) / settings_.teleop.dt_s);
}

DriveOutput LiveDrive::step(const DriveInput& input) {
    DriveOutput output;
    lookAt(input, output);
    std::vector<std::vector<JointMotion>> before;
    for (const Part& part : parts_)
        before.push_back(part.teleoperator.motion());
    stepParts(input, output);
    keepApart(before, output);
    write(output);
    last_q_ = output.q;
    return output;
}

}  // namespace noctule::robot
