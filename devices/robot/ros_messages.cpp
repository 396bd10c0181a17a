// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/ros_messages.h"

#include <algorithm>
#include <cmath>

#include "core/job/limits.h"

namespace noctule::robot_link {
namespace {

using nlohmann::json;

constexpr int64_t kSecond_ns = 1'000'000'000;
constexpr int64_t kLatest_s = 4'000'000'000;  // beyond the year 2090 a stamp is a mistake

Error wrong(const std::string& what) {
    return {ErrorKind::kUnreadable, what,
            "Send rosbridge v2 with the message types of devices/robot/README.md"};
}

/// nlohmann has no limit of depth of its own.
bool isTooDeep(std::string_view text) {
    int depth = 0, deepest = 0;
    bool in_text = false, escaped = false;
    for (const char letter : text) {
        if (in_text) {
            in_text = escaped || letter != '"';
            escaped = !escaped && letter == '\\';
        } else if (letter == '"') {
            in_text = true;
        } else if (letter == '[' || letter == '{') {
            deepest = std::max(deepest, ++depth);
        } else if (letter == ']' || letter == '}') {
            --depth;
        }
    }
    return deepest > limits::kBoxJsonDepth;
}

/// Absent: "". False: it is no text, or a long one.
bool readText(const json& object, const char* member, std::string& into) {
    const auto found = object.find(member);
    if (found == object.end())
        return true;
    if (!found->is_string() || found->get_ref<const std::string&>().size() > limits::kName)
        return false;
    into = found->get<std::string>();
    return true;
}

bool readNumber(const json& value, double& into) {
    if (!value.is_number())
        return false;
    into = value.get<double>();
    return std::abs(into) <= kLargestValue;
}

bool readNumbers(const json& object, const char* member, std::vector<double>& into) {
    const auto found = object.find(member);
    if (found == object.end())
        return true;
    if (!found->is_array() || found->size() > kMostJointsOfMessage)
        return false;
    into.resize(found->size());
    for (size_t i = 0; i < into.size(); ++i)
        if (!readNumber((*found)[i], into[i]))
            return false;
    return true;
}

bool readNames(const json& object, const char* member, std::vector<std::string>& into) {
    const auto found = object.find(member);
    if (found == object.end() || !found->is_array() || found->size() > kMostJointsOfMessage)
        return false;
    for (const json& name : *found) {
        if (!name.is_string() || name.get_ref<const std::string&>().size() > limits::kName)
            return false;
        into.push_back(name.get<std::string>());
    }
    return true;
}

/// ROS 1 writes secs and nsecs, ROS 2 sec and nanosec. 0: there is none.
int64_t readStamp(const json& msg) {
    const json* at = &msg;
    for (const char* member : {"header", "stamp"}) {
        const auto found = at->is_object() ? at->find(member) : at->end();
        if (found == at->end() || !found->is_object())
            return 0;
        at = &*found;
    }
    const auto number = [&](const char* one, const char* other, int64_t most) -> int64_t {
        const auto found = at->contains(one) ? at->find(one) : at->find(other);
        if (found == at->end() || !found->is_number_integer())
            return 0;
        const auto value = found->get<int64_t>();
        return value >= 0 && value <= most ? value : 0;
    };
    return number("secs", "sec", kLatest_s) * kSecond_ns + number("nsecs", "nanosec", kSecond_ns - 1);
}

/// Places must be there, speeds may be left out.
Result<JointMessage> completed(JointMessage named, const char* what) {
    if (named.v.empty())
        named.v.assign(named.q.size(), 0);
    if (named.q.size() != named.names.size() || named.v.size() != named.names.size())
        return wrong(std::string(what) +
                     ": as many positions as names are needed, and as many or no velocities");
    return named;
}

bool readVector(const json& object, const char* member,
                std::initializer_list<std::pair<const char*, double*>> parts) {
    const auto found = object.is_object() ? object.find(member) : object.end();
    if (found == object.end() || !found->is_object())
        return false;
    for (const auto& [name, into] : parts)
        if (!found->contains(name) || !readNumber((*found)[name], *into))
            return false;
    return true;
}

}  // namespace

std::string advertise(const std::string& topic, const std::string& type) {
    return json{{"op", "advertise"}, {"topic", topic}, {"type", type}}.dump();
}

std::string subscribe(const std::string& topic, const std::string& type) {
    return json{{"op", "subscribe"}, {"topic", topic}, {"type", type}, {"queue_length", 1}}.dump();
}

std::string publish(const std::string& topic, const json& msg) {
    return json{{"op", "publish"}, {"topic", topic}, {"msg", msg}}.dump();
}

std::string statusText(const std::string& level, const std::string& what) {
    return json{{"op", "status"}, {"level", level}, {"msg", what}}.dump(-1, ' ', false,
                                                                        json::error_handler_t::replace);
}

Result<RosOperation> readOperation(std::string_view text) {
    if (text.size() > kMostTextBytes)
        return wrong("a message of " + std::to_string(text.size()) + " bytes is too long");
    if (isTooDeep(text))
        return wrong("a message is nested too deeply");
    json object = json::parse(text, nullptr, false);
    if (!object.is_object())
        return wrong("a message is no JSON object");
    RosOperation operation;
    if (!readText(object, "op", operation.op) || !readText(object, "topic", operation.topic) ||
        !readText(object, "type", operation.type) || operation.op.empty())
        return wrong("a message has no \"op\", or \"op\", \"topic\" or \"type\" is no text");
    if (const auto msg = object.find("msg"); msg != object.end())
        operation.msg = std::move(*msg);
    return operation;
}

json stampOf(int64_t wall_ns) {
    return {{"secs", wall_ns / kSecond_ns}, {"nsecs", wall_ns % kSecond_ns}};
}

json jointState(const std::vector<std::string>& joints, const std::vector<double>& q,
                const std::vector<double>& v, int64_t wall_ns) {
    return {{"header", {{"stamp", stampOf(wall_ns)}, {"frame_id", ""}}},
            {"name", joints},
            {"position", q},
            {"velocity", v},
            {"effort", json::array()}};
}

json jointTrajectory(const std::vector<std::string>& joints, const RobotCommand& command, double ahead_s,
                     int64_t wall_ns) {
    return {{"header", {{"stamp", stampOf(wall_ns)}, {"frame_id", ""}}},
            {"joint_names", joints},
            {"points", json::array({{{"positions", command.q},
                                     {"velocities", command.v},
                                     {"accelerations", json::array()},
                                     {"effort", json::array()},
                                     {"time_from_start", stampOf(std::llround(ahead_s * 1e9))}}})}};
}

json poseStamped(const TipPose& tip, int64_t wall_ns) {
    const Vector3d& p = tip.p_base_tip;
    const Quaterniond& q = tip.q_base_tip;
    return {{"header", {{"stamp", stampOf(wall_ns)}, {"frame_id", tip.frame}}},
            {"pose",
             {{"position", {{"x", p.x()}, {"y", p.y()}, {"z", p.z()}}},
              {"orientation", {{"x", q.x()}, {"y", q.y()}, {"z", q.z()}, {"w", q.w()}}}}}};
}

Result<JointMessage> readJointState(const json& msg) {
    JointMessage named;
    if (!msg.is_object() || !readNames(msg, "name", named.names) || !readNumbers(msg, "position", named.q) ||
        !readNumbers(msg, "velocity", named.v))
        return wrong("a JointState has no names, or a value that is no number in range");
    named.wall_ns = readStamp(msg);
    return completed(std::move(named), "JointState");
}

Result<JointMessage> readJointTrajectory(const json& msg) {
    JointMessage named;
    if (!msg.is_object() || !readNames(msg, "joint_names", named.names))
        return wrong("a JointTrajectory has no joint_names");
    const auto points = msg.find("points");
    if (points == msg.end() || !points->is_array() || points->empty() || !points->back().is_object())
        return wrong("a JointTrajectory has no points");
    if (!readNumbers(points->back(), "positions", named.q) ||
        !readNumbers(points->back(), "velocities", named.v))
        return wrong("a JointTrajectory has a value that is no number in range");
    named.wall_ns = readStamp(msg);
    return completed(std::move(named), "JointTrajectory");
}

Result<TipPose> readPoseStamped(const json& msg) {
    TipPose tip;
    double w = 0, x = 0, y = 0, z = 0;
    const auto pose = msg.is_object() ? msg.find("pose") : msg.end();
    if (pose == msg.end() ||
        !readVector(*pose, "position",
                    {{"x", &tip.p_base_tip.x()}, {"y", &tip.p_base_tip.y()}, {"z", &tip.p_base_tip.z()}}) ||
        !readVector(*pose, "orientation", {{"x", &x}, {"y", &y}, {"z", &z}, {"w", &w}}))
        return wrong("a PoseStamped has no pose, or a value that is no number in range");
    tip.q_base_tip = Quaterniond(w, x, y, z);
    if (std::abs(tip.q_base_tip.norm() - 1) > 0.01)
        return wrong("a PoseStamped has an orientation that is no unit quaternion");
    tip.q_base_tip.normalize();
    if (const auto header = msg.find("header"); header != msg.end() && header->is_object())
        if (!readText(*header, "frame_id", tip.frame))
            return wrong("a PoseStamped has a frame_id that is no text");
    return tip;
}

bool sortInto(const std::vector<std::string>& joints, const JointMessage& named, std::vector<double>& q,
              std::vector<double>& v) {
    q.resize(joints.size());
    v.resize(joints.size());
    bool has_all = true;
    for (size_t i = 0; i < joints.size(); ++i) {
        const auto found = std::ranges::find(named.names, joints[i]);
        has_all &= found != named.names.end();
        if (found == named.names.end())
            continue;
        const auto at = static_cast<size_t>(found - named.names.begin());
        q[i] = named.q[at];
        v[i] = named.v[at];
    }
    return has_all;
}

}  // namespace noctule::robot_link
