// SPDX-License-Identifier: Apache-2.0
// The node towards ROS 1. Its headers are no C++20, so ros_node.cpp is C++17, and here stand plain types
// only.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace noctule::ros_bridge {

struct RosOptions {
    std::vector<std::string> joints;
    std::string command_topic, state_topic;
    bool as_trajectory = false;  ///< trajectory_msgs/JointTrajectory in place of sensor_msgs/JointState
    double ahead_s = 0;          ///< when a trajectory's point shall be reached
};

class RosNode {
public:
    /// Names, places and speeds of one sensor_msgs/JointState.
    using Heard = std::function<void(const std::vector<std::string>&, const std::vector<double>&,
                                     const std::vector<double>&)>;

    /// Once, before everything else. Takes the arguments that are ROS's own out of the list.
    static void initialise(int& argc, char** argv);
    static bool masterAnswers();
    static std::string masterUri();

    RosNode(const RosOptions& options, Heard heard);
    ~RosNode();
    RosNode(const RosNode&) = delete;
    RosNode& operator=(const RosNode&) = delete;

    /// One value a joint, rad and rad/s.
    void publish(const std::vector<double>& q, const std::vector<double>& v);
    /// Calls `heard` for what has come. False: ROS ends the node.
    bool spinOnce();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace noctule::ros_bridge
