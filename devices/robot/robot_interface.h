// SPDX-License-Identifier: Apache-2.0
// A robot's own interface as the studio drives it: commands out, states back. An interface works on a thread
// of its own; all calls return at once and may come from any thread. A new kind is one file and one line of
// the registry in make_interface.cpp.
#pragma once

#include <memory>

#include "core/job/result.h"
#include "core/live/latency.h"
#include "devices/robot/link_types.h"

namespace noctule::robot_link {

/// Messages that carry a command over rosbridge.
enum class RosCommand { kJointState, kJointTrajectory, kPose };

struct LinkOptions {
    std::vector<std::string> joints;  ///< in the order of commands; as the URDF names them
    double period_s = 1.0 / 140;      ///< between commands
    RosCommand ros_command = RosCommand::kJointState;
    std::string command_topic;                  ///< empty: the default of README.md
    std::string state_topic = "/joint_states";  ///< sensor_msgs/JointState
    std::vector<std::string> arms;              ///< names in TipPose; of RosCommand::kPose
};

struct LinkStatus {
    bool is_connected = false;        ///< udp: a state has come; rosbridge: the connection stands
    std::optional<RobotState> state;  ///< the newest with all joints
    int64_t state_arrived_ns = 0;     ///< std::chrono::steady_clock
    std::optional<Error> trouble;     ///< the last thing that went wrong, while it lasts
    bool is_hopeless = false;         ///< nothing is tried any more: the network does not know its name
    int64_t sent = 0, states = 0, refused_messages = 0, dropped = 0, reconnections = 0;
    LatencyHistogram latency;  ///< from pose_arrived_ns to after the write
};

class RobotInterface {
public:
    RobotInterface() = default;
    RobotInterface(const RobotInterface&) = delete;
    RobotInterface& operator=(const RobotInterface&) = delete;
    /// Closes; nothing is sent any more when it returns.
    virtual ~RobotInterface() = default;

    /// "udp://10.0.0.5:41950", "ws://10.0.0.5:9090"
    virtual const std::string& address() const = 0;
    /// Once. Connects, and connects again whenever the connection breaks.
    virtual void open() = 0;
    /// The newest command; one that is still unsent when the next comes is dropped.
    virtual void send(const RobotCommand& command) = 0;
    virtual LinkStatus status() const = 0;
};

/// kUsage names what is wrong with the address or the options and what addresses look like. Sends nothing
/// yet, and does not look names up: open() does.
Result<std::unique_ptr<RobotInterface>> makeInterface(const std::string& address, const LinkOptions& options);

}  // namespace noctule::robot_link
