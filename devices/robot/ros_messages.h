// SPDX-License-Identifier: Apache-2.0
// The JSON of rosbridge v2 and of the messages that go through it: operations and ROS messages <-> commands
// and states. No Qt, no sockets. Protocol: github.com/RobotWebTools/rosbridge_suite, ROSBRIDGE_PROTOCOL.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/job/result.h"
#include "devices/robot/link_types.h"

namespace noctule::robot_link {

/// Bytes of one incoming text at most; a JointState of 64 joints takes 5 kB.
inline constexpr size_t kMostTextBytes = 256 * 1024;
/// Joints in one JointState at most, ours and others.
inline constexpr size_t kMostJointsOfMessage = 1024;

inline constexpr const char* kJointState = "sensor_msgs/JointState";
inline constexpr const char* kJointTrajectory = "trajectory_msgs/JointTrajectory";
inline constexpr const char* kPoseStamped = "geometry_msgs/PoseStamped";

/// One operation: {"op": ..., "topic": ..., "type": ..., "msg": ...}.
struct RosOperation {
    std::string op, topic, type;
    nlohmann::json msg;
};
std::string advertise(const std::string& topic, const std::string& type);
std::string subscribe(const std::string& topic, const std::string& type);
std::string publish(const std::string& topic, const nlohmann::json& msg);
/// {"op": "status"}: how a rosbridge says what was wrong.
std::string statusText(const std::string& level, const std::string& what);
/// kUnreadable: no JSON object, too long or too deep, no "op", or members of a wrong type.
Result<RosOperation> readOperation(std::string_view text);

/// {"secs", "nsecs"}, as ROS 1 has it; since 1970.
nlohmann::json stampOf(int64_t wall_ns);
nlohmann::json jointState(const std::vector<std::string>& joints, const std::vector<double>& q,
                          const std::vector<double>& v, int64_t wall_ns);
/// One point: the command, to be reached `ahead_s` after the stamp.
nlohmann::json jointTrajectory(const std::vector<std::string>& joints, const RobotCommand& command,
                               double ahead_s, int64_t wall_ns);
nlohmann::json poseStamped(const TipPose& tip, int64_t wall_ns);

/// Values by name, as a message brings them.
struct JointMessage {
    std::vector<std::string> names;
    std::vector<double> q, v;  ///< v: zeros where the message has none
    int64_t wall_ns = 0;       ///< 0: no stamp
};
Result<JointMessage> readJointState(const nlohmann::json& msg);
/// The last point of a JointTrajectory.
Result<JointMessage> readJointTrajectory(const nlohmann::json& msg);
Result<TipPose> readPoseStamped(const nlohmann::json& msg);

/// Puts named values in the order of `joints`; others are ignored. False: one of ours is missing, and what
/// was known of it stays.
bool sortInto(const std::vector<std::string>& joints, const JointMessage& named, std::vector<double>& q,
              std::vector<double>& v);

}  // namespace noctule::robot_link
