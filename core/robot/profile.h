// SPDX-License-Identifier: Apache-2.0
// How a robot's arms and legs answer to a performer's: which joints are shoulder, elbow and wrist, how the
// robot's base stands to a chest, the limits of motion. A leg is described as an arm is: its shoulder is the
// hip, its elbow the knee, its wrist the ankle, its hand the foot. Saved per robot as JSON (README.md); made
// from the URDF by names and shape where there is none.
#pragma once

#include <nlohmann/json.hpp>

#include "core/robot/chain.h"
#include "core/robot/performer_arms.h"

namespace noctule::robot {

enum class Limb {
    kArm,  ///< seen from the shoulder, in the axes of the chest
    kLeg,  ///< seen from between the hips, in their axes; in the reference posture it stands straight
};

struct ArmProfile {
    Limb limb = Limb::kArm;
    std::string name;          ///< "right"
    Side side = Side::kRight;  ///< which arm of the performer moves it
    std::string base, tip;     ///< links; the base carries the shoulders
    /// Joints whose origins stand for the performer's; no wrist joint: a point of the elbow's link.
    std::string shoulder_joint, elbow_joint, wrist_joint;
    Vector3d p_elbow_wrist_m = Vector3d::Zero();
    /// Axes of the performer's chest (x left, y up, z forward) in the base link's frame.
    Matrix3d R_base_body = Matrix3d::Identity();
    /// Joint values in the reference posture: upper arm down, forearm ahead.
    std::vector<double> reference_rad;
    std::vector<double> max_speed;  ///< rad/s, per joint of the chain
};

struct MappingWeights {
    double posture = 0.09;  ///< of the squared chord of upper arm and forearm
    double wrist_per_arm =
        0.3;             ///< the scaled wrist's sigma as a part of the scale; smaller: place before posture
    double hand = 0.01;  ///< of the squared turn of the hand; 0: the wrist's joints keep still
    double stay = 1e-4;  ///< of the squared way of each joint in a frame
};

struct RobotProfile {
    std::string robot;
    std::vector<ArmProfile> arms;
    std::vector<ArmProfile> legs;               ///< left and right, or none
    std::vector<std::string> trunk_joints;      ///< from the root up to the arms' base; followed by the chest
    std::string trunk_base, trunk_tip;          ///< links around them
    double max_acceleration = 0, max_jerk = 0;  ///< rad/s^2 and rad/s^3; 0: not limited
    double capsule_radius_m = 0.04;             ///< of links without a primitive shape
    double clearance_m = 0.01;  ///< between capsules of different parts; 0: they are not watched
    MappingWeights weights;
};

/// Speed of joints whose file states none that means anything.
inline constexpr double kUsualSpeed_rad_per_s = 2.5;
inline double usableSpeed(double stated_rad_per_s) {
    return stated_rad_per_s > kHighestSpeed_rad_per_s ? kUsualSpeed_rad_per_s : stated_rad_per_s;
}

/// An arm with its joints looked up in the robot.
struct RobotArm {
    ArmProfile profile;
    Chain chain;
    int shoulder = 0, elbow = 0, wrist = -1;
    JointVector reference;
    double length_m = 0;                         ///< shoulder to elbow to wrist
    Matrix3d R_body_tip = Matrix3d::Identity();  ///< in the reference posture
    std::optional<Vector3d> p_base_centre_m{};   ///< of a leg: between both hips, in the base's frame

    struct Points {
        Vector3d shoulder, elbow, wrist;  ///< in the base's frame
    };
    Points points(const ChainState& state) const;
};

/// kUnusable names the joint or link that the robot has not.
Result<RobotArm> makeArm(const RobotModel& model, const ArmProfile& profile);

/// kUnusable when no arm is found; the remedy says what to write. With legs where they are known by name.
Result<RobotProfile> makeProfile(const RobotModel& model);
/// Two legs of 4 to 6 joints by their names, or none.
std::vector<ArmProfile> makeLegs(const RobotModel& model);
/// Both of them, with what they share. kUnusable when the profile has no legs, or they do not fit.
Result<std::vector<RobotArm>> legsOf(const RobotModel& model, const RobotProfile& profile);
/// A foot keeps its place before the leg looks like the performer's.
MappingWeights weightsOfLegs();

nlohmann::json toJson(const RobotProfile& profile);
/// `where` names the file in errors (kUnreadable).
Result<RobotProfile> profileFromJson(const nlohmann::json& json, const std::string& where);

}  // namespace noctule::robot
