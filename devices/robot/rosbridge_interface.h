// SPDX-License-Identifier: Apache-2.0
// ROS 1 and ROS 2 through rosbridge v2 over WebSocket: commands are published, the robot's state is
// subscribed. Connects again twice a second while the other end is away.
#pragma once

#include <QTimer>
#include <QUrl>
#include <QWebSocket>

#include "devices/device/loop_thread.h"
#include "devices/robot/link_book.h"
#include "devices/robot/ros_messages.h"

namespace noctule::robot_link {

/// "/noctule/joint_command", "/noctule/joint_trajectory" or "/noctule/ARM/pose_command".
std::string commandTopic(const LinkOptions& options, const std::string& arm = {});
const char* messageType(RosCommand command);

class RosbridgeInterface : public RobotInterface {
public:
    static constexpr int kAgain_ms = 500;
    static constexpr int kConnectTime_ms = 3000;

    RosbridgeInterface(std::string address, QUrl url, LinkOptions options);
    ~RosbridgeInterface() override { thread_.reset(); }

    const std::string& address() const override { return address_; }
    void open() override;
    void send(const RobotCommand& command) override;
    LinkStatus status() const override { return book_.status(); }

private:
    // On the thread:
    void connectSocket();
    void greet();
    void retry(const std::string& why);
    void giveUp();
    void write();
    void read(const QString& text);
    void readState(const nlohmann::json& msg);

    const std::string address_;
    const QUrl url_;
    const LinkOptions options_;
    LinkBook book_;
    std::unique_ptr<QWebSocket> socket_;  ///< lives on the thread
    std::unique_ptr<QTimer> again_;
    bool was_connected_ = false, gave_up_ = false;
    RobotState state_;
    std::vector<bool> known_;             ///< joints of which a value has come
    std::unique_ptr<LoopThread> thread_;  ///< last: it uses the others
};

}  // namespace noctule::robot_link
