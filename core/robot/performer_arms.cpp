// SPDX-License-Identifier: Apache-2.0
#include "core/robot/performer_arms.h"

#include <cmath>

#include "core/body/bone_names.h"
#include "core/math/rotation.h"

namespace noctule::robot {
namespace {

constexpr double kShortestBone_m = 0.01;

std::map<std::string, int> bonesOf(const Skeleton& skeleton) {
    std::vector<NamedBone> bones;
    for (const Joint& joint : skeleton.joints())
        bones.push_back({joint.name, joint.parent});
    return jointsByName(bones).bone_of_joint;
}

int commonAncestor(const Skeleton& skeleton, int a, int b) {
    for (; a >= 0; a = skeleton.joint(a).parent)
        for (int other = b; other >= 0; other = skeleton.joint(other).parent)
            if (other == a)
                return a;
    return 0;
}

Matrix3d turn(const Quaterniond& q) {
    return q.toRotationMatrix();
}

double largestOf(const std::vector<double>& sigma_rad, int joint) {
    double largest = 0;
    for (size_t at = 3 * static_cast<size_t>(joint), end = at + 3; at < std::min(end, sigma_rad.size()); ++at)
        largest = std::max(largest, sigma_rad[at]);
    return largest;
}

}  // namespace

Result<PerformerArms> PerformerArms::make(const Skeleton& skeleton, const std::string& where) {
    const auto bones = bonesOf(skeleton);
    PerformerArms made;
    const std::string sides[] = {"Left", "Right"};
    for (size_t s = 0; s < 2; ++s) {
        int* const wanted[] = {&made.arms_[s].upper, &made.arms_[s].forearm, &made.arms_[s].hand};
        const char* const names[] = {"Arm", "ForeArm", "Hand"};
        for (size_t i = 0; i < 3; ++i) {
            const auto found = bones.find(sides[s] + names[i]);
            if (found == bones.end())
                return Error{ErrorKind::kUnusable, where + ": no bone is known as " + sides[s] + names[i],
                             "Take a motion with both arms, or rename its joints"};
            *wanted[i] = found->second;
        }
    }
    made.hips_ = bones.contains("Hips") ? bones.at("Hips") : 0;
    made.chest_ = commonAncestor(skeleton, made.arms_[0].upper, made.arms_[1].upper);
    for (int joint = made.chest_; joint >= 0 && joint != made.hips_; joint = skeleton.joint(joint).parent)
        made.spine_.push_back(joint);
    const GlobalPose zero = globalPose(skeleton, skeleton.zeroPose());
    const auto place = [&](int joint) { return zero.p_world_joint[static_cast<size_t>(joint)]; };
    const Vector3d across = place(made.arms_[0].upper) - place(made.arms_[1].upper);
    const Vector3d middle = (place(made.arms_[0].upper) + place(made.arms_[1].upper)) / 2;
    const Vector3d forward = across.cross(middle - place(made.hips_));
    if (across.norm() < kShortestBone_m || forward.norm() < kShortestBone_m * kShortestBone_m)
        return Error{ErrorKind::kUnusable, where + ": its shoulders and hips stand in one line",
                     "Take a motion whose skeleton has a trunk"};
    made.R_world_body_.col(0) = across.normalized();
    made.R_world_body_.col(2) = forward.normalized();
    made.R_world_body_.col(1) = made.R_world_body_.col(2).cross(made.R_world_body_.col(0));
    for (size_t s = 0; s < 2; ++s) {
        ArmBones& arm = made.arms_[s];
        const Vector3d upper = place(arm.forearm) - place(arm.upper);
        const Vector3d forearm = place(arm.hand) - place(arm.forearm);
        if (upper.norm() < kShortestBone_m || forearm.norm() < kShortestBone_m)
            return Error{ErrorKind::kUnusable,
                         where + ": the arm on the " + (s ? "right" : "left") + " has a bone without length",
                         "Take a motion with whole arms"};
        made.arm_length_m_[s] = upper.norm() + forearm.norm();
        const Vector3d outwards = made.R_world_body_.col(0) * (s ? -1 : 1);
        arm.R_upper_t = turn(smallestRotation(outwards, upper)) * made.R_world_body_;
        arm.R_forearm_t = turn(smallestRotation(outwards, forearm)) * made.R_world_body_;
        arm.R_hand_t = arm.R_forearm_t;  // the hand lies as the forearm in the zero pose
    }
    made.findLegs(skeleton, bones);
    return made;
}

void PerformerArms::findLegs(const Skeleton& skeleton, const std::map<std::string, int>& bones) {
    const GlobalPose zero = globalPose(skeleton, skeleton.zeroPose());
    const auto place = [&](int joint) { return zero.p_world_joint[static_cast<size_t>(joint)]; };
    std::array<ArmBones, 2> legs;
    double length_m = 0;
    const std::string sides[] = {"Left", "Right"};
    for (size_t s = 0; s < 2; ++s) {
        int* const wanted[] = {&legs[s].upper, &legs[s].forearm, &legs[s].hand};
        const char* const names[] = {"UpLeg", "Leg", "Foot"};
        for (size_t i = 0; i < 3; ++i) {
            const auto found = bones.find(sides[s] + names[i]);
            if (found == bones.end())
                return;
            *wanted[i] = found->second;
        }
        const Vector3d thigh = place(legs[s].forearm) - place(legs[s].upper);
        const Vector3d shank = place(legs[s].hand) - place(legs[s].forearm);
        if (thigh.norm() < kShortestBone_m || shank.norm() < kShortestBone_m)
            return;
        length_m += (thigh.norm() + shank.norm()) / 2;
        const Vector3d down = -R_world_body_.col(1);
        legs[s].R_upper_t = turn(smallestRotation(down, thigh)) * R_world_body_;
        legs[s].R_forearm_t = turn(smallestRotation(down, shank)) * R_world_body_;
        legs[s].R_hand_t = R_world_body_;  // the foot is flat in the zero pose
    }
    legs_ = legs;
    leg_length_m_ = length_m;
}

ArmPose PerformerArms::armAt(const GlobalPose& pose, const ArmBones& bones,
                             const Matrix3d& R_world_body) const {
    const auto place = [&](int joint) { return pose.p_world_joint[static_cast<size_t>(joint)]; };
    const auto rotation = [&](int joint) { return turn(pose.q_world_joint[static_cast<size_t>(joint)]); };
    const Matrix3d R_body_world = R_world_body.transpose();
    ArmPose arm;
    arm.upper = (R_body_world * (place(bones.forearm) - place(bones.upper))).normalized();
    arm.forearm = (R_body_world * (place(bones.hand) - place(bones.forearm))).normalized();
    arm.wrist_m = R_body_world * (place(bones.hand) - place(bones.upper));
    arm.R_upper = R_body_world * rotation(bones.upper) * bones.R_upper_t;
    arm.R_forearm = R_body_world * rotation(bones.forearm) * bones.R_forearm_t;
    arm.R_hand = R_body_world * rotation(bones.hand) * bones.R_hand_t;
    return arm;
}

PerformerFrame PerformerArms::at(const GlobalPose& pose) const {
    const auto rotation = [&](int joint) { return turn(pose.q_world_joint[static_cast<size_t>(joint)]); };
    const Matrix3d R_world_chest = rotation(chest_) * R_world_body_;
    PerformerFrame frame;
    for (size_t s = 0; s < 2; ++s) {
        frame.in_chest[s] = armAt(pose, arms_[s], R_world_chest);
        frame.in_world[s] = armAt(pose, arms_[s], R_world_body_);
    }
    const Vector3d forward = R_world_body_.transpose() * R_world_chest.col(2);
    frame.heading_rad = std::atan2(forward.x(), forward.z());
    const Matrix3d R_world_hips = rotation(hips_) * R_world_body_;
    frame.R_hips_chest = R_world_hips.transpose() * R_world_chest;
    if (legs_) {
        const auto hip = [&](size_t s) { return pose.p_world_joint[static_cast<size_t>((*legs_)[s].upper)]; };
        frame.legs = LegsPose{{}, R_world_hips, (hip(0) + hip(1)) / 2};
        for (size_t s = 0; s < 2; ++s) {
            ArmPose& leg = frame.legs->in_hips[s];
            leg = armAt(pose, (*legs_)[s], R_world_hips);
            leg.wrist_m += R_world_hips.transpose() * (hip(s) - frame.legs->p_world_hips_m);
        }
    }
    return frame;
}

double PerformerArms::worstSigma_rad(const std::vector<double>& sigma_rad) const {
    double worst = 0;
    for (const ArmBones& arm : arms_)
        for (const int joint : {arm.upper, arm.forearm, arm.hand})
            worst = std::max(worst, largestOf(sigma_rad, joint));
    return worst;
}

double PerformerArms::trunkSigma_rad(const std::vector<double>& sigma_rad) const {
    double worst = 0;
    for (const int joint : spine_)
        worst = std::max(worst, largestOf(sigma_rad, joint));
    return worst;
}

Matrix3d PerformerArms::referenceUpper(Side side) {
    const double down = side == Side::kLeft ? -radians(90) : radians(90);
    return turn(axisAngle(Vector3d::UnitZ(), down));
}

Matrix3d PerformerArms::referenceForearm(Side side) {
    return turn(axisAngle(Vector3d::UnitX(), -radians(90))) * referenceUpper(side);
}

}  // namespace noctule::robot
