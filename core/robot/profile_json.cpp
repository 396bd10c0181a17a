// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"
#include "core/robot/profile.h"

namespace noctule::robot {
namespace {

constexpr const char* kFormat = "noctule robot profile";
constexpr int kVersion = 1;
constexpr size_t kMostArms = 2;

/// Numbers of a profile with the range in which they are read.
struct ProfileNumber {
    const char* name;
    double RobotProfile::*member;
    double min, max;
};
constexpr ProfileNumber kNumbers[] = {
    {"max_acceleration_rad_per_s2", &RobotProfile::max_acceleration, 0, 1e4},
    {"max_jerk_rad_per_s3", &RobotProfile::max_jerk, 0, 1e6},
    {"capsule_radius_m", &RobotProfile::capsule_radius_m, 0.001, 1},
    {"clearance_m", &RobotProfile::clearance_m, 0, 1}};
struct WeightNumber {
    const char* name;
    double MappingWeights::*member;
    double min, max;
};
constexpr WeightNumber kWeights[] = {{"posture", &MappingWeights::posture, 0, 100},
                                     {"wrist_per_arm", &MappingWeights::wrist_per_arm, 0.001, 100},
                                     {"hand", &MappingWeights::hand, 0, 100},
                                     {"stay", &MappingWeights::stay, 1e-9, 1}};

/// Reads one member after the other; the first that does not fit is the error.
class ProfileReader {
public:
    explicit ProfileReader(std::string where) : where_(std::move(where)) {}

    void fail(const std::string& member, const std::string& wanted) {
        if (!error_)
            error_ = Error{ErrorKind::kUnreadable, where_ + ": \"" + member + "\" is not " + wanted,
                           "Correct the profile, or have one made with --profile-out"};
    }
    std::string text(const json::Json& object, const char* member, bool may_be_empty = false) {
        const auto found = json::text(object, member);
        if (!found || found->size() > limits::kName || (found->empty() && !may_be_empty))
            fail(member, "a name");
        return found.value_or("");
    }
    void number(const json::Json& object, const char* member, double min, double max, double& value) {
        if (!object.contains(member))
            return;
        const auto found = json::number(object, member);
        if (found && *found >= min && *found <= max)
            value = *found;
        else
            fail(member, "a number from " + json::Json(min).dump() + " to " + json::Json(max).dump());
    }
    std::vector<double> list(const json::Json& object, const char* member, double min, double max) {
        std::vector<double> values;
        const auto found = object.find(member);
        if (found == object.end() || !found->is_array() || found->size() > kMostChainJoints) {
            fail(member, "a list of numbers");
            return values;
        }
        for (const auto& one : *found) {
            const auto value = json::number(one);
            if (!value || *value < min || *value > max)
                fail(member,
                     "a list of numbers from " + json::Json(min).dump() + " to " + json::Json(max).dump());
            values.push_back(value.value_or(0));
        }
        return values;
    }
    const std::optional<Error>& error() const { return error_; }

private:
    std::string where_;
    std::optional<Error> error_;
};

json::Json armJson(const ArmProfile& arm) {
    json::Json object{{"name", arm.name},
                      {"side", arm.side == Side::kLeft ? "left" : "right"},
                      {"base", arm.base},
                      {"tip", arm.tip},
                      {"shoulder_joint", arm.shoulder_joint},
                      {"elbow_joint", arm.elbow_joint},
                      {"wrist_joint", arm.wrist_joint},
                      {"left_axis", json::fromVector(arm.R_base_body.col(0))},
                      {"up_axis", json::fromVector(arm.R_base_body.col(1))},
                      {"reference_rad", arm.reference_rad},
                      {"max_speed_rad_per_s", arm.max_speed}};
    if (arm.wrist_joint.empty())
        object["wrist_in_elbow_link_m"] = json::fromVector(arm.p_elbow_wrist_m);
    return object;
}

ArmProfile armFrom(const json::Json& object, ProfileReader& read) {
    ArmProfile arm;
    if (!object.is_object()) {
        read.fail("arms", "a list of objects");
        return arm;
    }
    arm.name = read.text(object, "name");
    const std::string side = read.text(object, "side");
    if (side != "left" && side != "right")
        read.fail("side", "left or right");
    arm.side = side == "left" ? Side::kLeft : Side::kRight;
    arm.base = read.text(object, "base");
    arm.tip = read.text(object, "tip");
    arm.shoulder_joint = read.text(object, "shoulder_joint");
    arm.elbow_joint = read.text(object, "elbow_joint");
    arm.wrist_joint = read.text(object, "wrist_joint", true);
    if (arm.wrist_joint.empty()) {
        const auto p = json::vector3(object, "wrist_in_elbow_link_m");
        if (!p || p->norm() > limits::kLengthOfBody_m)
            read.fail("wrist_in_elbow_link_m", "a place [x, y, z] in m");
        arm.p_elbow_wrist_m = p.value_or(Vector3d::UnitX());
    }
    const auto left = json::vector3(object, "left_axis"), up = json::vector3(object, "up_axis");
    if (!left || !up || std::abs(left->norm() - 1) > 0.01 || std::abs(up->norm() - 1) > 0.01 ||
        std::abs(left->dot(*up)) > 0.01) {
        read.fail("left_axis\" and \"up_axis", "a pair of perpendicular unit vectors");
    } else {
        // Exact axes are kept to the bit, so that a profile reads back as it was.
        arm.R_base_body << *left, *up, left->cross(*up);
        if (std::abs(left->norm() - 1) > 1e-9 || std::abs(left->dot(*up)) > 1e-9)
            arm.R_base_body = Quaterniond(arm.R_base_body).normalized().toRotationMatrix();
    }
    arm.reference_rad = read.list(object, "reference_rad", -100, 100);
    arm.max_speed = read.list(object, "max_speed_rad_per_s", 1e-3, kHighestSpeed_rad_per_s);
    return arm;
}

}  // namespace

nlohmann::json toJson(const RobotProfile& profile) {
    json::Json object{{"format", kFormat}, {"version", kVersion}, {"robot", profile.robot}};
    for (const ProfileNumber& number : kNumbers)
        object[number.name] = profile.*number.member;
    for (const WeightNumber& weight : kWeights)
        object["weights"][weight.name] = profile.weights.*weight.member;
    object["arms"] = json::Json::array();
    for (const ArmProfile& arm : profile.arms)
        object["arms"].push_back(armJson(arm));
    for (const ArmProfile& leg : profile.legs)
        object["legs"].push_back(armJson(leg));
    if (!profile.trunk_joints.empty())
        object["trunk"] = {
            {"joints", profile.trunk_joints}, {"base", profile.trunk_base}, {"tip", profile.trunk_tip}};
    return object;
}

Result<RobotProfile> profileFromJson(const nlohmann::json& object, const std::string& where) {
    ProfileReader read(where);
    if (!object.is_object() || json::text(object, "format") != kFormat)
        return Error{ErrorKind::kUnreadable, where + ": is no profile of a robot",
                     "Choose another file, or have one made with --profile-out"};
    if (json::number(object, "version") != kVersion)
        return Error{ErrorKind::kUnreadable, where + ": is a profile of another version than 1",
                     "Take a newer program, or have one made with --profile-out"};
    RobotProfile profile;
    profile.robot = read.text(object, "robot", true);
    for (const ProfileNumber& number : kNumbers)
        read.number(object, number.name, number.min, number.max, profile.*number.member);
    if (const auto weights = object.find("weights"); weights != object.end() && weights->is_object())
        for (const WeightNumber& weight : kWeights)
            read.number(*weights, weight.name, weight.min, weight.max, profile.weights.*weight.member);
    const auto arms = object.find("arms");
    if (arms == object.end() || !arms->is_array() || arms->empty() || arms->size() > kMostArms)
        read.fail("arms", "a list of one or two arms");
    else
        for (const auto& arm : *arms)
            profile.arms.push_back(armFrom(arm, read));
    if (const auto legs = object.find("legs"); legs != object.end()) {
        if (!legs->is_array() || legs->size() != 2)
            read.fail("legs", "a list of two legs");
        else
            for (const auto& leg : *legs) {
                profile.legs.push_back(armFrom(leg, read));
                profile.legs.back().limb = Limb::kLeg;
            }
    }
    if (const auto trunk = object.find("trunk"); trunk != object.end()) {
        profile.trunk_base = read.text(*trunk, "base");
        profile.trunk_tip = read.text(*trunk, "tip");
        const auto joints = trunk->is_object() ? trunk->find("joints") : trunk->end();
        if (!trunk->is_object() || joints == trunk->end() || !joints->is_array() ||
            joints->size() > kMostChainJoints)
            read.fail("joints", "a list of the trunk's joints");
        else
            for (const auto& joint : *joints)
                profile.trunk_joints.push_back(joint.is_string() ? joint.get<std::string>() : "");
    }
    if (read.error())
        return *read.error();
    return profile;
}

}  // namespace noctule::robot
