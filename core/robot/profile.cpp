// SPDX-License-Identifier: Apache-2.0
#include "core/robot/profile.h"

#include <algorithm>
#include <cmath>

namespace noctule::robot {
namespace {

Error missing(const std::string& what) {
    return {ErrorKind::kUnusable, "the profile does not fit the robot: " + what,
            "Correct the profile, or leave it out to have one made"};
}

}  // namespace

RobotArm::Points RobotArm::points(const ChainState& state) const {
    const auto at = [](int joint) { return static_cast<size_t>(joint); };
    return {state.p_base_joint[at(shoulder)], state.p_base_joint[at(elbow)],
            wrist >= 0 ? state.p_base_joint[at(wrist)]
                       : Vector3d(state.p_base_joint[at(elbow)] +
                                  state.R_base_link[at(elbow)] * profile.p_elbow_wrist_m)};
}

Result<RobotArm> makeArm(const RobotModel& model, const ArmProfile& profile) {
    auto chain = Chain::make(model, profile.base, profile.tip);
    if (!chain)
        return chain.error();
    RobotArm arm{profile, std::move(*chain), 0, 0, -1, {}, 0, Matrix3d::Identity(), {}};
    const auto size = static_cast<size_t>(arm.chain.size());
    if (profile.reference_rad.size() != size || profile.max_speed.size() != size)
        return missing("arm " + profile.name + " has " + std::to_string(size) +
                       " joints, its reference or speeds have another number");
    arm.shoulder = arm.chain.find(profile.shoulder_joint);
    arm.elbow = arm.chain.find(profile.elbow_joint);
    arm.wrist = arm.chain.find(profile.wrist_joint);
    const auto absent = [&](const std::string& joint) {
        return missing("joint \"" + joint + "\" is not in arm " + profile.name);
    };
    if (arm.shoulder < 0 || arm.elbow < 0)
        return absent(arm.shoulder < 0 ? profile.shoulder_joint : profile.elbow_joint);
    if (arm.wrist < 0 && !profile.wrist_joint.empty())
        return absent(profile.wrist_joint);
    if (arm.elbow <= arm.shoulder || (arm.wrist >= 0 && arm.wrist <= arm.elbow))
        return missing("shoulder, elbow and wrist of arm " + profile.name + " do not follow one another");
    arm.reference.resize(static_cast<Eigen::Index>(size));
    for (size_t i = 0; i < size; ++i) {
        const ChainJoint& joint = arm.chain.joint(static_cast<int>(i));
        const double value = profile.reference_rad[i];
        if (value < joint.lower - 1e-6 || value > joint.upper + 1e-6)
            return missing("the reference of joint \"" + joint.name + "\" is outside its limits");
        arm.reference[static_cast<Eigen::Index>(i)] = std::clamp(value, joint.lower, joint.upper);
    }
    ChainState state;
    arm.chain.forward(arm.reference, state);
    const RobotArm::Points points = arm.points(state);
    const double upper_m = (points.elbow - points.shoulder).norm();
    const double forearm_m = (points.wrist - points.elbow).norm();
    if (upper_m < 0.01 || forearm_m < 0.01)
        return missing("upper arm or forearm of arm " + profile.name + " is shorter than 1 cm");
    arm.length_m = upper_m + forearm_m;
    arm.R_body_tip = profile.R_base_body.transpose() * state.R_base_tip;
    return arm;
}

Result<std::vector<RobotArm>> legsOf(const RobotModel& model, const RobotProfile& profile) {
    if (profile.legs.size() != 2)
        return Error{ErrorKind::kUnusable, "robot " + profile.robot + " has no two legs",
                     "Leave --legs out, or describe them in the profile"};
    std::vector<RobotArm> legs;
    Vector3d centre_m = Vector3d::Zero();
    for (const ArmProfile& wanted : profile.legs) {
        auto leg = makeArm(model, wanted);
        if (!leg)
            return leg.error();
        ChainState state;
        leg->chain.forward(leg->reference, state);
        centre_m += leg->points(state).shoulder / 2;
        legs.push_back(std::move(*leg));
    }
    if (legs[0].profile.base != legs[1].profile.base)
        return missing("its legs have two bases");
    for (RobotArm& leg : legs)
        leg.p_base_centre_m = centre_m;
    return legs;
}

MappingWeights weightsOfLegs() {
    MappingWeights weights;
    weights.posture = 0.02;
    weights.wrist_per_arm = 0.02;
    weights.hand = 0.3;
    return weights;
}

}  // namespace noctule::robot
