// SPDX-License-Identifier: Apache-2.0
#include "app/ros_bridge/ros_node.h"

#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <trajectory_msgs/JointTrajectory.h>

#include <utility>

namespace noctule::ros_bridge {
namespace {

constexpr int kQueuedMessages = 1;  // an old command is worse than none

}  // namespace

struct RosNode::Parts {
    Parts(const RosOptions& of, Heard listener) : options(of), heard(std::move(listener)) {}

    const RosOptions options;
    const Heard heard;
    ros::NodeHandle node;
    ros::Publisher commands;
    ros::Subscriber states;

    void hear(const sensor_msgs::JointState& message) {
        heard(message.name, message.position, message.velocity);
    }
};

void RosNode::initialise(int& argc, char** argv) {
    ros::init(argc, argv, "noctule_bridge",
              ros::init_options::NoSigintHandler | ros::init_options::AnonymousName);
}

bool RosNode::masterAnswers() {
    return ros::master::check();
}

std::string RosNode::masterUri() {
    return ros::master::getURI();
}

RosNode::RosNode(const RosOptions& options, Heard heard) : parts_(new Parts(options, std::move(heard))) {
    Parts& parts = *parts_;
    parts.commands =
        options.as_trajectory
            ? parts.node.advertise<trajectory_msgs::JointTrajectory>(options.command_topic, kQueuedMessages)
            : parts.node.advertise<sensor_msgs::JointState>(options.command_topic, kQueuedMessages);
    parts.states = parts.node.subscribe(options.state_topic, kQueuedMessages, &Parts::hear, parts_.get(),
                                        ros::TransportHints().tcpNoDelay());
}

RosNode::~RosNode() = default;

void RosNode::publish(const std::vector<double>& q, const std::vector<double>& v) {
    const Parts& parts = *parts_;
    if (parts.options.as_trajectory) {
        trajectory_msgs::JointTrajectory message;
        message.header.stamp = ros::Time::now();
        message.joint_names = parts.options.joints;
        message.points.resize(1);
        message.points[0].positions = q;
        message.points[0].velocities = v;
        message.points[0].time_from_start = ros::Duration(parts.options.ahead_s);
        parts.commands.publish(message);
        return;
    }
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time::now();
    message.name = parts.options.joints;
    message.position = q;
    message.velocity = v;
    parts.commands.publish(message);
}

bool RosNode::spinOnce() {
    ros::spinOnce();
    return ros::ok();
}

}  // namespace noctule::ros_bridge
