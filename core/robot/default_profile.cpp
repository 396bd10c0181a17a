// SPDX-License-Identifier: Apache-2.0
// A profile from names and shape. Arms are the longest chains of moving joints whose names are of no leg,
// finger, head or trunk; "left" and "right" in names tell the side, a single arm follows the right one. The
// n-th joints that stand for shoulder, elbow and wrist follow from the number of joints.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/math/rotation.h"
#include "core/robot/arm_follower.h"
#include "core/robot/inverse_kinematics.h"
#include "core/robot/profile.h"

namespace noctule::robot {
namespace {

std::string lowered(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool holdsOne(const std::string& text, std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// Name of the joint and of the link that it carries.
std::string wordsOf(const RobotModel& model, const RobotJoint& joint) {
    return lowered(joint.name + " " + model.links[static_cast<size_t>(joint.child_link)].name);
}

bool isTrunk(const std::string& words) {
    return holdsOne(words, {"waist", "torso", "trunk", "spine", "chest"});
}

bool mayBeArm(const RobotModel& model, const RobotJoint& joint) {
    const std::string words = wordsOf(model, joint);
    return joint.moves() && !joint.mimic &&
           !holdsOne(words,
                     {"hip", "knee", "ankle", "leg", "toe", "foot", "finger", "thumb", "index", "middle",
                      "ring", "little", "pinky", "grip", "neck", "head", "camera", "wheel"}) &&
           !(isTrunk(words) && !holdsOne(words, {"left", "right"}));
}

/// Moving joints of one arm from its first to its last.
using ArmJoints = std::vector<int>;

ArmJoints longestChain(const RobotModel& model, const std::string& side) {
    ArmJoints longest;
    for (size_t link = 0; link < model.links.size(); ++link) {
        ArmJoints chain;
        for (const int index : model.jointsAbove(static_cast<int>(link))) {
            const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
            const bool is_of_side = side.empty() || holdsOne(wordsOf(model, joint), {side.c_str()});
            if (is_of_side && mayBeArm(model, joint))
                chain.push_back(index);
        }
        if (chain.size() > longest.size())
            longest = chain;
    }
    return longest;
}

/// Of the chain's joints those that stand for shoulder, elbow and wrist (-1: none).
struct Landmarks {
    size_t shoulder = 1, elbow = 3;
    int wrist = -1;
};

std::optional<Landmarks> landmarksOf(size_t joints) {
    switch (joints) {
        case 7:
            return Landmarks{1, 3, 5};
        case 6:
            return Landmarks{1, 2, 3};
        case 5:
            return Landmarks{1, 3, 4};
        case 4:
            return Landmarks{1, 3, -1};
        default:
            return std::nullopt;
    }
}

int commonLink(const RobotModel& model, int a, int b) {
    const std::vector<int> above_a = model.jointsAbove(a), above_b = model.jointsAbove(b);
    int link = 0;
    for (size_t i = 0; i < std::min(above_a.size(), above_b.size()) && above_a[i] == above_b[i]; ++i)
        link = model.joints[static_cast<size_t>(above_a[i])].child_link;
    return link;
}

int parentOfFirst(const RobotModel& model, const ArmJoints& arm) {
    return model.joints[static_cast<size_t>(arm.front())].parent_link;
}

Vector3d shoulderIn(const RobotModel& model, int base, const ArmJoints& arm) {
    const RobotJoint& joint = model.joints[static_cast<size_t>(arm[1])];
    return placeAtZero(model, base, joint.child_link).translation();
}

/// Chest's axes in the base: up is that of the root link (REP 103), left goes from shoulder to shoulder, of a
/// single arm it is that of the root link.
Matrix3d bodyAxes(const RobotModel& model, int base, const std::vector<ArmJoints>& arms) {
    const Matrix3d R_base_root = placeAtZero(model, base, 0).linear();
    const Vector3d up = R_base_root.col(2);
    Vector3d left = R_base_root.col(1);
    if (arms.size() == 2)
        left = shoulderIn(model, base, arms[0]) - shoulderIn(model, base, arms[1]);
    left = (left - up * up.dot(left)).normalized();
    Matrix3d R;
    R << left, up, left.cross(up);
    return R;
}

/// Twice the way to the centre of mass of the elbow's link and what is fixed to it: where a wrist would be.
Vector3d pointOfForearm(const RobotModel& model, const RobotJoint& elbow) {
    const RobotLink& link = model.links[static_cast<size_t>(elbow.child_link)];
    return link.centre_m ? Vector3d(2 * *link.centre_m) : Vector3d(0.2 * Vector3d::UnitX());
}

/// The posture nearest to the reference: of many starts the one that fits best, then the least turned.
std::vector<double> referenceOf(const RobotModel& model, ArmProfile profile) {
    auto arm = makeArm(model, profile);
    if (!arm)
        return profile.reference_rad;
    const Side side = profile.side;
    RobotProfile robot;
    robot.weights.hand = 0;
    ArmPose pose;
    const Vector3d outwards = Vector3d::UnitX() * (side == Side::kLeft ? 1 : -1);
    pose.upper = PerformerArms::referenceUpper(side) * outwards;
    pose.forearm = PerformerArms::referenceForearm(side) * outwards;
    pose.wrist_m = 0.5 * (pose.upper + pose.forearm);
    RandomPostures random(3);
    double best = std::numeric_limits<double>::infinity();
    JointVector q = arm->reference;
    for (int start = 0; start < 60; ++start) {
        ArmFollower follower(*arm, robot, 1.0, 0.01);
        follower.settle(pose);
        const ArmCommand command = follower.hold(pose);
        const double misfit = command.upper_deg + command.forearm_deg;
        // A radian of turning weighs as much as two degrees of misfit.
        const double cost = misfit + 2 * command.q.norm();
        if (cost < best) {
            best = cost;
            q = command.q;
        }
        arm->reference = random.next(arm->chain);
        for (int i = std::max(arm->elbow + 1, 0); i < arm->chain.size(); ++i)  // forearm and wrist at 0
            arm->reference[i] = std::clamp(0.0, arm->chain.joint(i).lower, arm->chain.joint(i).upper);
    }
    return {q.begin(), q.end()};
}

ArmProfile armOf(const RobotModel& model, int base, const ArmJoints& joints, Side side,
                 const Matrix3d& axes) {
    const Landmarks at = *landmarksOf(joints.size());
    const auto joint = [&](size_t i) -> const RobotJoint& {
        return model.joints[static_cast<size_t>(joints[i])];
    };
    ArmProfile profile;
    profile.name = side == Side::kLeft ? "left" : "right";
    profile.side = side;
    profile.base = model.links[static_cast<size_t>(base)].name;
    profile.tip = model.links[static_cast<size_t>(joint(joints.size() - 1).child_link)].name;
    profile.shoulder_joint = joint(at.shoulder).name;
    profile.elbow_joint = joint(at.elbow).name;
    if (at.wrist >= 0)
        profile.wrist_joint = joint(static_cast<size_t>(at.wrist)).name;
    else
        profile.p_elbow_wrist_m = pointOfForearm(model, joint(at.elbow));
    profile.R_base_body = axes;
    const auto chain = Chain::make(model, profile.base, profile.tip);
    if (!chain)
        return profile;
    for (int i = 0; i < chain->size(); ++i) {
        profile.max_speed.push_back(usableSpeed(chain->joint(i).max_speed));
        profile.reference_rad.push_back(std::clamp(0.0, chain->joint(i).lower, chain->joint(i).upper));
    }
    profile.reference_rad = referenceOf(model, profile);
    return profile;
}

void addTrunk(const RobotModel& model, int base, RobotProfile& profile) {
    for (const int index : model.jointsAbove(base)) {
        const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
        if (!joint.moves() || joint.mimic || !isTrunk(wordsOf(model, joint)))
            continue;
        if (profile.trunk_joints.empty())
            profile.trunk_base = model.links[static_cast<size_t>(joint.parent_link)].name;
        profile.trunk_joints.push_back(joint.name);
        profile.trunk_tip = model.links[static_cast<size_t>(base)].name;
    }
}

/// Moving joints of one leg, from the first to the last: below the hip of that side, with a knee.
ArmJoints legJoints(const RobotModel& model, const std::string& side) {
    ArmJoints longest;
    for (size_t link = 0; link < model.links.size(); ++link) {
        ArmJoints chain;
        for (const int index : model.jointsAbove(static_cast<int>(link))) {
            const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
            const std::string words = wordsOf(model, joint);
            if (joint.moves() && !joint.mimic && holdsOne(words, {side.c_str()}) &&
                holdsOne(words, {"hip", "knee", "ankle", "leg", "thigh", "shin", "calf"}))
                chain.push_back(index);
        }
        if (chain.size() > longest.size())
            longest = chain;
    }
    return longest;
}

/// Of a leg: its knee by name; its hip, the last joint above it that does not turn the thigh about itself.
std::optional<Landmarks> landmarksOfLeg(const RobotModel& model, const ArmJoints& joints) {
    constexpr double kAlong = 0.7;  // cosine between the axis and the thigh
    const auto knee = std::ranges::find_if(joints, [&](int index) {
        return holdsOne(lowered(model.joints[static_cast<size_t>(index)].name), {"knee"});
    });
    const auto at = static_cast<size_t>(knee - joints.begin());
    if (joints.size() < 4 || joints.size() > 6 || at < 2 || at + 1 >= joints.size())
        return std::nullopt;
    const auto place = [&](size_t i) {
        return placeAtZero(model, 0, model.joints[static_cast<size_t>(joints[i])].child_link);
    };
    const Vector3d thigh = (place(at).translation() - place(0).translation()).normalized();
    for (size_t hip = at; hip-- > 0;) {
        const Vector3d axis = place(hip).linear() * model.joints[static_cast<size_t>(joints[hip])].axis;
        if (std::abs(axis.dot(thigh)) < kAlong)
            return Landmarks{hip, at, static_cast<int>(at) + 1};
    }
    return std::nullopt;
}

}  // namespace

std::vector<ArmProfile> makeLegs(const RobotModel& model) {
    std::vector<ArmProfile> legs;
    const std::array joints{legJoints(model, "left"), legJoints(model, "right")};
    if (joints[0].empty() || joints[1].empty())
        return {};
    const int base = commonLink(model, parentOfFirst(model, joints[0]), parentOfFirst(model, joints[1]));
    for (size_t s = 0; s < 2; ++s) {
        const auto at = landmarksOfLeg(model, joints[s]);
        if (!at)
            return {};
        const auto joint = [&](size_t i) -> const RobotJoint& {
            return model.joints[static_cast<size_t>(joints[s][i])];
        };
        ArmProfile leg;
        leg.limb = Limb::kLeg;
        leg.name = s == 0 ? "left" : "right";
        leg.side = s == 0 ? Side::kLeft : Side::kRight;
        leg.base = model.links[static_cast<size_t>(base)].name;
        leg.tip = model.links[static_cast<size_t>(joint(joints[s].size() - 1).child_link)].name;
        leg.shoulder_joint = joint(at->shoulder).name;
        leg.elbow_joint = joint(at->elbow).name;
        leg.wrist_joint = joint(static_cast<size_t>(at->wrist)).name;
        leg.R_base_body = bodyAxes(model, base, {joints[0], joints[1]});
        for (const int index : joints[s]) {
            const RobotJoint& one = model.joints[static_cast<size_t>(index)];
            leg.max_speed.push_back(usableSpeed(one.max_speed));
            leg.reference_rad.push_back(std::clamp(0.0, one.lower, one.upper));
        }
        if (const auto made = makeArm(model, leg); !made)
            return {};
        legs.push_back(std::move(leg));
    }
    return legs;
}

Result<RobotProfile> makeProfile(const RobotModel& model) {
    const auto none = [&](const std::string& what) {
        return Error{ErrorKind::kUnusable, "robot " + model.name + ": " + what,
                     "Give a profile that names the joints (core/robot/README.md)"};
    };
    std::vector<ArmJoints> arms{longestChain(model, "left"), longestChain(model, "right")};
    if (arms[0].empty() || arms[1].empty())
        arms = {longestChain(model, "")};
    for (const ArmJoints& arm : arms)
        if (!landmarksOf(arm.size()))
            return none("no arm of 4 to 7 joints is known by its names (" + std::to_string(arm.size()) +
                        " found)");
    const int base = arms.size() == 2
                         ? commonLink(model, parentOfFirst(model, arms[0]), parentOfFirst(model, arms[1]))
                         : parentOfFirst(model, arms[0]);
    const Matrix3d axes = bodyAxes(model, base, arms);
    RobotProfile profile;
    profile.robot = model.name;
    for (size_t i = 0; i < arms.size(); ++i) {
        const Side side = arms.size() == 2 && i == 0 ? Side::kLeft : Side::kRight;
        profile.arms.push_back(armOf(model, base, arms[i], side, axes));
        if (auto made = makeArm(model, profile.arms.back()); !made)
            return made.error();
    }
    addTrunk(model, base, profile);
    profile.legs = makeLegs(model);
    return profile;
}

}  // namespace noctule::robot
