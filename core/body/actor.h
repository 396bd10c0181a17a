// SPDX-License-Identifier: Apache-2.0
// A performer: skeleton in the performer's measures, the rest pose asked for, and capsules that stand for the
// flesh (occlusion of sound). The default actor has the 21 canonical joints of the take format.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/body/skeleton.h"

namespace noctule {

struct Capsule {
    std::string segment;
    Vector3d a_m = Vector3d::Zero(), b_m = Vector3d::Zero();  ///< in the segment's frame
    double radius_m = 0;
};

struct Actor {
    std::string name;
    double height_m = 0;
    Skeleton skeleton;
    std::vector<Quaterniond> rest_q_parent_joint;  ///< rest pose, root yaw 0
    std::vector<Capsule> capsules;

    /// The rest pose with the root above the world's origin so that the lowest joint or tip touches y = 0.
    Pose restPose() const;
};

/// Lengths of a person in metres; 0 means "in proportion to the height".
struct BodyMeasures {
    double height_m = 1.75;
    double upper_arm_m = 0, forearm_m = 0, hand_m = 0, shoulder_width_m = 0;
    double thigh_m = 0, shin_m = 0, foot_m = 0, hip_width_m = 0, trunk_m = 0;
};

/// The 21 canonical joint names in the order of the default actor.
const std::vector<std::string>& canonicalJointNames();

/// Proportions after Winter, "Biomechanics and Motor Control of Human Movement", 4th ed., figure 4.1.
Actor defaultActor(const BodyMeasures& measures = {});

/// Take-format JSON (docs: core/recording/README.md, section 6). Unknown members are ignored.
nlohmann::json toJson(const Actor& actor);
/// `where` names the file or take in errors (kUnreadable: not an actor; kUnusable: contradictory).
Result<Actor> actorFromJson(const nlohmann::json& json, const std::string& where);

}  // namespace noctule
