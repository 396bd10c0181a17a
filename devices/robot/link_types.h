// SPDX-License-Identifier: Apache-2.0
// What goes between the studio and a robot, whatever the interface: one command or one state of all driven
// joints. Values in rad, rad/s (prismatic: m, m/s), in the order of LinkOptions::joints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::robot_link {

/// Joints of one link at most; a datagram of so many still fits into one Ethernet frame.
inline constexpr size_t kMostJoints = 64;
/// A joint value beyond this is no command and no state: a turn, 160 times.
inline constexpr double kLargestValue = 1000;

/// Where the tip of an arm shall be, in the frame of its base link.
struct TipPose {
    std::string arm, frame;
    Vector3d p_base_tip = Vector3d::Zero();
    Quaterniond q_base_tip = Quaterniond::Identity();
};

enum CommandFlag : uint32_t {
    kFollows = 1,      ///< an operator drives
    kHolds = 2,        ///< the arm stands, or brakes
    kStopPressed = 4,  ///< the operator pressed stop
};

enum StateFlag : uint32_t {
    kRefuses = 1,  ///< the last command was too far from where the robot is
};

struct RobotCommand {
    uint64_t sequence = 0;        ///< counts up by 1
    int64_t time_ns = 0;          ///< of the sender's monotonic clock
    int64_t pose_arrived_ns = 0;  ///< when the data of a new pose came, same clock; 0: no new pose
    uint32_t flags = 0;           ///< CommandFlag
    std::vector<double> q, v;
    std::vector<TipPose> tips;
};

struct RobotState {
    uint64_t sequence = 0;         ///< counts up by 1; 0: the interface has none
    int64_t time_ns = 0;           ///< of the robot's clock
    uint64_t obeyed_sequence = 0;  ///< the newest command heard; 0: none, or the interface does not tell
    uint32_t flags = 0;            ///< StateFlag
    std::vector<double> q, v;
};

/// True when sizes fit and all values are finite and within kLargestValue.
bool areSound(const std::vector<double>& q, const std::vector<double>& v, size_t joints);

}  // namespace noctule::robot_link
