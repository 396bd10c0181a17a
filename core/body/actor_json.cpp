// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/body/actor.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"

namespace noctule {
namespace {

using json::Json;

Error notReadable(const std::string& where, const std::string& what) {
    return {ErrorKind::kUnreadable, where + ": " + what, "Correct the actor's JSON or choose another actor"};
}

Json jointToJson(const Joint& joint) {
    Json j{{"name", joint.name}, {"parent", joint.parent}, {"offset_m", json::fromVector(joint.offset_m)}};
    if (joint.type == JointType::kFree)
        j["free"] = true;
    if (joint.type == JointType::kBall)
        j["ball"] = true;
    j["dof"] = Json::array();
    for (const DegreeOfFreedom& dof : joint.dof)
        j["dof"].push_back({{"name", dof.name},
                            {"axis", json::fromVector(dof.axis)},
                            {"min_rad", dof.min_rad},
                            {"max_rad", dof.max_rad}});
    if (joint.end_m)
        j["end_m"] = json::fromVector(*joint.end_m);
    if (!joint.aliases.empty())
        j["aliases"] = joint.aliases;
    return j;
}

Result<DegreeOfFreedom> dofFromJson(const Json& j, const std::string& where, const std::string& joint) {
    DegreeOfFreedom dof;
    dof.name = shortText(json::text(j, "name").value_or(""), limits::kName);
    const auto axis = json::vector3(j, "axis");
    if (!axis || axis->norm() < 1e-9)
        return notReadable(where,
                           "joint " + joint + ": the axis of freedom '" + dof.name + "' is not a direction");
    dof.axis = axis->normalized();
    dof.min_rad = json::number(j, "min_rad").value_or(dof.min_rad);
    dof.max_rad = json::number(j, "max_rad").value_or(dof.max_rad);
    return dof;
}

JointType typeOf(const Json& j, size_t dof_count) {
    if (j.value("free", Json(false)) == Json(true))
        return JointType::kFree;
    if (j.value("ball", Json(false)) == Json(true))
        return JointType::kBall;
    constexpr JointType kByCount[] = {JointType::kFixed, JointType::kHinge, JointType::kUniversal,
                                      JointType::kBall};
    return kByCount[std::min<size_t>(dof_count, 3)];
}

Result<Joint> jointFromJson(const Json& j, const std::string& where, size_t index) {
    Joint joint;
    const auto name = json::text(j, "name");
    const auto parent = json::number(j, "parent");
    const auto offset = json::vector3(j, "offset_m");
    if (!name || !parent || !offset)
        return notReadable(where,
                           "joint number " + std::to_string(index) + " lacks name, parent or offset_m");
    if (offset->norm() > limits::kLengthOfBody_m)
        return notReadable(where,
                           "joint " + shortText(*name, limits::kName) + ": offset_m is longer than 10 m");
    joint.name = shortText(*name, limits::kName);
    joint.parent = static_cast<int>(std::clamp(*parent, -1.0, 1e6));
    joint.offset_m = *offset;
    joint.end_m = json::vector3(j, "end_m");
    if (joint.end_m && joint.end_m->norm() > limits::kLengthOfBody_m)
        return notReadable(where, "joint " + joint.name + ": end_m is farther than 10 m");
    if (const auto dofs = j.find("dof"); dofs != j.end() && dofs->is_array()) {
        if (dofs->size() > limits::kFreedomsOfJoint)
            return notReadable(where, "joint " + joint.name + ": dof has more than three entries");
        for (const Json& d : *dofs) {
            Result<DegreeOfFreedom> dof = dofFromJson(d, where, joint.name);
            if (!dof)
                return dof.error();
            joint.dof.push_back(*dof);
        }
    }
    joint.type = typeOf(j, joint.dof.size());
    if (joint.type == JointType::kFree)
        joint.dof.clear();
    if (const auto aliases = j.find("aliases"); aliases != j.end() && aliases->is_object())
        for (const auto& [key, value] : aliases->items())
            if (value.is_string())
                joint.aliases[key] = value.get<std::string>();
    return joint;
}

Result<std::vector<Quaterniond>> restFromJson(const Json& j, const std::string& where,
                                              const Skeleton& skeleton) {
    std::vector<Quaterniond> rest(static_cast<size_t>(skeleton.size()), Quaterniond::Identity());
    const auto object = j.find("rest");
    if (object == j.end() || !object->is_object() || !object->contains("q"))
        return rest;
    const Json& list = (*object)["q"];
    if (!list.is_array() || list.size() != rest.size())
        return notReadable(where, "the rest pose does not hold one quaternion per joint");
    for (size_t i = 0; i < rest.size(); ++i) {
        const auto q = json::quaternion(list[i]);
        if (!q)
            return notReadable(where,
                               "rest pose: joint " + skeleton.joints()[i].name + " has no unit quaternion");
        rest[i] = *q;
    }
    return rest;
}

Result<std::vector<Capsule>> capsulesFromJson(const Json& j, const std::string& where,
                                              const Skeleton& skeleton) {
    std::vector<Capsule> capsules;
    const auto list = j.find("capsules");
    if (list == j.end() || !list->is_array())
        return capsules;
    if (list->size() > limits::kCapsules)
        return notReadable(where, "there are more than 1024 capsules");
    for (const Json& c : *list) {
        const auto segment = json::text(c, "segment");
        const auto a = json::vector3(c, "a_m"), b = json::vector3(c, "b_m");
        const auto radius = json::number(c, "radius_m");
        if (!segment || !a || !b || !radius || *radius <= 0)
            return notReadable(where, "a capsule lacks segment, a_m, b_m or radius_m");
        if (std::max({a->norm(), b->norm(), *radius}) > limits::kLengthOfBody_m)
            return notReadable(where, "the capsule of " + *segment + " reaches farther than 10 m");
        if (skeleton.find(*segment) < 0)
            return notReadable(where, "a capsule names the unknown segment " + *segment);
        capsules.push_back({*segment, *a, *b, *radius});
    }
    return capsules;
}

}  // namespace

Pose Actor::restPose() const {
    Pose pose{Vector3d::Zero(), rest_q_parent_joint};
    const GlobalPose global = globalPose(skeleton, pose);
    double lowest_m = 0;
    for (int i = 0; i < skeleton.size(); ++i) {
        const size_t k = static_cast<size_t>(i);
        lowest_m = std::min(lowest_m, global.p_world_joint[k].y());
        if (const auto& end = skeleton.joint(i).end_m)
            lowest_m = std::min(lowest_m, (global.p_world_joint[k] + global.q_world_joint[k] * *end).y());
    }
    pose.p_world_root.y() = -lowest_m;
    return pose;
}

nlohmann::json toJson(const Actor& actor) {
    Json j{{"format", "noctule-actor"}, {"version", 1}, {"name", actor.name}, {"height_m", actor.height_m}};
    j["joints"] = Json::array();
    for (const Joint& joint : actor.skeleton.joints())
        j["joints"].push_back(jointToJson(joint));
    Json rest = Json::array();
    for (const Quaterniond& q : actor.rest_q_parent_joint)
        rest.push_back(json::fromQuaternion(q));
    j["rest"] = {{"q", rest}};
    j["capsules"] = Json::array();
    for (const Capsule& c : actor.capsules)
        j["capsules"].push_back({{"segment", c.segment},
                                 {"a_m", json::fromVector(c.a_m)},
                                 {"b_m", json::fromVector(c.b_m)},
                                 {"radius_m", c.radius_m}});
    return j;
}

Result<Actor> actorFromJson(const nlohmann::json& j, const std::string& where) {
    if (json::text(j, "format") != "noctule-actor")
        return notReadable(where, "this is not an actor (format is not noctule-actor)");
    if (json::number(j, "version").value_or(1) != 1)
        return notReadable(where, "this actor has a newer version than this program reads");
    const auto list = j.find("joints");
    if (list == j.end() || !list->is_array())
        return notReadable(where, "the actor has no joints");
    if (list->size() > limits::kJoints)
        return notReadable(where, "there are " + std::to_string(list->size()) + " joints, more than 256");
    if (json::number(j, "height_m").value_or(0) > limits::kLengthOfBody_m)
        return notReadable(where, "height_m is more than 10 m");
    std::vector<Joint> joints;
    for (size_t i = 0; i < list->size(); ++i) {
        Result<Joint> joint = jointFromJson((*list)[i], where, i);
        if (!joint)
            return joint.error();
        joints.push_back(std::move(*joint));
    }
    Result<Skeleton> skeleton = Skeleton::make(std::move(joints));
    if (!skeleton)
        return Error{skeleton.error().kind, where + ": " + skeleton.error().message, skeleton.error().remedy};
    Result<std::vector<Quaterniond>> rest = restFromJson(j, where, *skeleton);
    if (!rest)
        return rest.error();
    Result<std::vector<Capsule>> capsules = capsulesFromJson(j, where, *skeleton);
    if (!capsules)
        return capsules.error();
    return Actor{shortText(json::text(j, "name").value_or("unnamed"), limits::kName),
                 json::number(j, "height_m").value_or(0), std::move(*skeleton), std::move(*rest),
                 std::move(*capsules)};
}

}  // namespace noctule
