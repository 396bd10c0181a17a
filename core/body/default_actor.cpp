// SPDX-License-Identifier: Apache-2.0
#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Lengths of an adult of 1.75 m, the reference that BodyMeasures scales.
/// Legs and arms after Winter, "Biomechanics and Motor Control of Human Movement", 4th ed., figure 4.1; the
/// trunk is divided where boards sit (pelvis, lower back, chest).
struct Lengths {
    double scale, trunk_scale;
    double upper_arm, forearm, hand, thigh, shin, foot;
    double shoulder_half_width, hip_half_width;
};

Lengths lengthsOf(const BodyMeasures& m) {
    const double scale = m.height_m / 1.75;
    const auto chosen = [scale](double measured, double adult) {
        return measured > 0 ? measured : adult * scale;
    };
    constexpr double kTrunk = 0.44;  // hip joint line to the base of the neck
    return {scale,
            chosen(m.trunk_m, kTrunk) / (kTrunk * scale),
            chosen(m.upper_arm_m, 0.29),
            chosen(m.forearm_m, 0.25),
            chosen(m.hand_m, 0.18),
            chosen(m.thigh_m, 0.43),
            chosen(m.shin_m, 0.43),
            chosen(m.foot_m, 0.13),
            chosen(m.shoulder_width_m, 0.34) / 2,
            chosen(m.hip_width_m, 0.18) / 2};
}

DegreeOfFreedom dof(const char* name, const Vector3d& axis, double min_rad, double max_rad) {
    return {name, axis, min_rad, max_rad};
}

Joint ball(const char* name, int parent, const Vector3d& offset_m, const std::string& prefix,
           double limit_rad) {
    return {name,
            parent,
            offset_m,
            JointType::kBall,
            {dof((prefix + "X").c_str(), Vector3d::UnitX(), -limit_rad, limit_rad),
             dof((prefix + "Y").c_str(), Vector3d::UnitY(), -limit_rad, limit_rad),
             dof((prefix + "Z").c_str(), Vector3d::UnitZ(), -limit_rad, limit_rad)},
            {},
            {}};
}

/// HumanIK and Mixamo keep the canonical names except for the chest.
void addAliases(std::vector<Joint>& joints) {
    for (Joint& joint : joints) {
        const std::string known = joint.name == "Chest" ? "Spine2" : joint.name;
        joint.aliases = {{"humanik", known}, {"mixamo", "mixamorig:" + known}};
    }
}

void addArm(std::vector<Joint>& joints, int chest, const std::string& side, double sign, const Lengths& l) {
    const Vector3d outward = sign * Vector3d::UnitX();
    const double trunk = l.scale * l.trunk_scale;
    const double clavicle_root = 0.02 * l.scale;
    joints.push_back(
        {side + "Shoulder",
         chest,
         {sign * clavicle_root, 0.22 * trunk, 0},
         JointType::kUniversal,
         {dof("elevation", Vector3d::UnitZ(), -0.9, 0.9), dof("protraction", Vector3d::UnitY(), -0.9, 0.9)},
         {},
         {}});
    const int shoulder = static_cast<int>(joints.size()) - 1;
    joints.push_back(
        ball("", shoulder, (l.shoulder_half_width - clavicle_root) * outward, "shoulder", std::numbers::pi));
    joints.back().name = side + "Arm";
    joints.push_back({side + "ForeArm",
                      shoulder + 1,
                      l.upper_arm * outward,
                      JointType::kUniversal,
                      {dof("flexion", -sign * Vector3d::UnitY(), -0.3, 3.0),
                       dof("pronation", Vector3d::UnitX(), -std::numbers::pi, std::numbers::pi)},
                      {},
                      {}});
    joints.push_back(
        {side + "Hand",
         shoulder + 2,
         l.forearm * outward,
         JointType::kUniversal,
         {dof("deviation", Vector3d::UnitZ(), -1.6, 1.6), dof("flexion", Vector3d::UnitY(), -1.8, 1.8)},
         Vector3d(l.hand * outward),
         {}});
}

void addLeg(std::vector<Joint>& joints, const std::string& side, double sign, const Lengths& l) {
    joints.push_back(ball("", 0, {sign * l.hip_half_width, -0.05 * l.scale, 0}, "hip", 2.6));
    joints.back().name = side + "UpLeg";
    const int thigh = static_cast<int>(joints.size()) - 1;
    joints.push_back({side + "Leg",
                      thigh,
                      {0, -l.thigh, 0},
                      JointType::kHinge,
                      {dof("flexion", Vector3d::UnitX(), -0.2, 2.9)},
                      {},
                      {}});
    joints.push_back(
        {side + "Foot",
         thigh + 1,
         {0, -l.shin, 0},
         JointType::kUniversal,
         {dof("inversion", Vector3d::UnitZ(), -1.2, 1.2), dof("flexion", Vector3d::UnitX(), -1.6, 1.6)},
         {},
         {}});
    joints.push_back({side + "ToeBase",
                      thigh + 2,
                      {0, -0.06 * l.scale, l.foot},
                      JointType::kFixed,
                      {},
                      Vector3d(0, 0, 0.06 * l.scale),
                      {}});
}

std::vector<Joint> defaultJoints(const Lengths& l) {
    const double trunk = l.scale * l.trunk_scale;
    std::vector<Joint> joints;
    joints.push_back({"Hips", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}});
    joints.push_back(ball("Spine", 0, {0, 0.06 * trunk, 0}, "spine", 2.6));
    joints.push_back(ball("Chest", 1, {0, 0.12 * trunk, 0}, "chest", 2.6));
    joints.push_back({"Neck", 2, {0, 0.26 * trunk, 0}, JointType::kFixed, {}, {}, {}});
    joints.push_back(ball("Head", 3, {0, 0.09 * l.scale, 0.01 * l.scale}, "head", 2.6));
    joints.back().end_m = Vector3d(0, 0.24 * l.scale, 0.02 * l.scale);
    addArm(joints, 2, "Left", 1, l);
    addArm(joints, 2, "Right", -1, l);
    addLeg(joints, "Left", 1, l);
    addLeg(joints, "Right", -1, l);
    addAliases(joints);
    return joints;
}

/// Arms hang beside the body, a little forward and away from it, elbows slightly bent: comfortable to hold,
/// and hands and forearms stay in sight of the sources.
std::vector<Quaterniond> defaultRest(const Skeleton& skeleton) {
    std::vector<Quaterniond> rest(static_cast<size_t>(skeleton.size()), Quaterniond::Identity());
    const auto set = [&](const char* joint, const Quaterniond& q) {
        rest[static_cast<size_t>(skeleton.find(joint))] = q.normalized();
    };
    set("LeftArm", {0.818896, -0.070397, -0.102898, -0.560237});
    set("RightArm", {0.818896, -0.070397, 0.102898, 0.560237});
    set("LeftForeArm", axisAngle(-Vector3d::UnitY(), 0.5));
    set("RightForeArm", axisAngle(Vector3d::UnitY(), 0.5));
    return rest;
}

void addLimbCapsules(std::vector<Capsule>& c, const std::string& side, double sign, const Lengths& l) {
    const auto along = [sign](double x) { return Vector3d(sign * x, 0, 0); };
    const auto down = [](double y) { return Vector3d(0, -y, 0); };
    const double s = l.scale;
    c.push_back({side + "Arm", along(0), along(l.upper_arm), 0.045 * s});
    c.push_back({side + "ForeArm", along(0), along(l.forearm / 2), 0.038 * s});
    c.push_back({side + "ForeArm", along(l.forearm / 2), along(l.forearm), 0.030 * s});
    c.push_back({side + "Hand", along(0.3 * l.hand), along(l.hand), 0.020 * s});
    c.push_back({side + "UpLeg", down(0.1 * l.thigh), down(l.thigh), 0.070 * s});
    c.push_back({side + "Leg", down(0), down(l.shin), 0.050 * s});
    c.push_back({side + "Foot", Vector3d::Zero(), Vector3d(0, -0.06 * s, l.foot), 0.035 * s});
}

std::vector<Capsule> defaultCapsules(const Lengths& l) {
    const double s = l.scale;
    const auto at = [s](double x, double y, double z) { return Vector3d(x * s, y * s, z * s); };
    std::vector<Capsule> c;
    c.push_back({"Hips", at(-0.06, -0.03, 0), at(0.06, -0.03, 0), 0.115 * s});
    c.push_back({"Spine", at(-0.03, 0.04, 0), at(0.03, 0.04, 0), 0.112 * s});
    c.push_back({"Chest", at(-0.02, -0.03, 0), at(-0.02, 0.14, 0), 0.115 * s});
    c.push_back({"Chest", at(0.02, -0.03, 0), at(0.02, 0.14, 0), 0.115 * s});
    c.push_back({"Head", at(0, 0.03, 0.01), at(0, 0.14, 0.02), 0.09 * s});
    addLimbCapsules(c, "Left", 1, l);
    addLimbCapsules(c, "Right", -1, l);
    return c;
}

}  // namespace

const std::vector<std::string>& canonicalJointNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> collected;
        for (const Joint& joint : defaultJoints(lengthsOf({})))
            collected.push_back(joint.name);
        return collected;
    }();
    return names;
}

Actor defaultActor(const BodyMeasures& measures) {
    const Lengths lengths = lengthsOf(measures);
    Actor actor;
    actor.name = "default";
    actor.height_m = measures.height_m;
    actor.skeleton = Skeleton::make(defaultJoints(lengths)).value();
    actor.rest_q_parent_joint = defaultRest(actor.skeleton);
    actor.capsules = defaultCapsules(lengths);
    return actor;
}

}  // namespace noctule
