// SPDX-License-Identifier: Apache-2.0
// The virtual robot's interfaces: one datagram per command and state, and a rosbridge v2 server of its own.
#pragma once

#include <QNetworkDatagram>
#include <QUdpSocket>
#include <QWebSocket>
#include <QWebSocketServer>
#include <map>
#include <memory>
#include <set>

#include "app/virtual_robot/robot_body.h"
#include "app/virtual_suit/address.h"
#include "devices/robot/datagram.h"
#include "devices/robot/ros_messages.h"

namespace noctule::virtual_robot {

class RobotPort {
public:
    virtual ~RobotPort() = default;
    virtual std::string address() const = 0;
    virtual void tellState() = 0;
    /// As if the cable were out, or in again.
    virtual void setReachable(bool reachable) = 0;
};

class UdpPort : public RobotPort {
public:
    /// kDevice when the port cannot be had.
    static Result<std::unique_ptr<UdpPort>> open(const virtual_suit::Address& address, RobotBody& body);
    std::string address() const override { return "udp://" + virtual_suit::toText(where_); }
    void tellState() override;
    void setReachable(bool reachable) override { reachable_ = reachable; }

private:
    explicit UdpPort(RobotBody& body) : body_(body), joints_hash_(robot_link::hashOf(body.joints())) {}
    void read();
    void handle(const QByteArray& bytes);

    RobotBody& body_;
    const uint64_t joints_hash_;
    virtual_suit::Address where_;
    QUdpSocket socket_;
    QHostAddress studio_;  ///< who asked or commanded last
    quint16 studio_port_ = 0;
    uint64_t sequence_ = 0;
    bool reachable_ = true;
};

class RosbridgePort : public RobotPort {
public:
    static constexpr size_t kMostClients = 8;

    static Result<std::unique_ptr<RosbridgePort>> open(const virtual_suit::Address& address, RobotBody& body,
                                                       std::vector<std::string> arms);
    std::string address() const override { return "ws://" + virtual_suit::toText(where_); }
    void tellState() override;
    void setReachable(bool reachable) override;

private:
    struct Client {
        std::unique_ptr<QWebSocket, void (*)(QWebSocket*)> socket;
        std::map<std::string, std::string> types;  ///< advertised topic -> type
        bool hears_state = false;
    };
    RosbridgePort(RobotBody& body, std::vector<std::string> arms);
    void welcome();
    void read(QWebSocket* socket, const QString& text);
    Status obey(Client& client, const robot_link::RosOperation& operation);
    Status obeyMessage(const std::string& type, const robot_link::RosOperation& operation);

    RobotBody& body_;
    const std::vector<std::string> arms_;
    virtual_suit::Address where_;
    QWebSocketServer server_;
    std::map<QWebSocket*, Client> clients_;
    uint64_t sequence_ = 0;
};

}  // namespace noctule::virtual_robot
