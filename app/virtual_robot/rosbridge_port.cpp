// SPDX-License-Identifier: Apache-2.0
#include <QDateTime>
#include <algorithm>

#include "app/virtual_robot/robot_ports.h"
#include "devices/machine/clock.h"

namespace noctule::virtual_robot {
namespace {

constexpr const char* kStateTopic = "/joint_states";
constexpr size_t kMostTopics = 64;
constexpr qint64 kMostUnsentBytes = 64 * 1024;

void deleteSocketLater(QWebSocket* socket) {
    socket->disconnect();
    socket->deleteLater();
}

Error refused(const std::string& what) {
    return {ErrorKind::kUsage, what, "See devices/robot/README.md"};
}

}  // namespace

Result<std::unique_ptr<RosbridgePort>> RosbridgePort::open(const virtual_suit::Address& address,
                                                           RobotBody& body, std::vector<std::string> arms) {
    std::unique_ptr<RosbridgePort> port(new RosbridgePort(body, std::move(arms)));
    if (!port->server_.listen(address.host, address.port))
        return Error{ErrorKind::kDevice,
                     virtual_suit::toText(address) +
                         ": cannot be listened on: " + port->server_.errorString().toStdString(),
                     "Give --rosbridge another port (0: any free one)"};
    port->where_ = {address.host, port->server_.serverPort()};
    return port;
}

RosbridgePort::RosbridgePort(RobotBody& body, std::vector<std::string> arms)
    : body_(body), arms_(std::move(arms)), server_("noctule-virtual-robot", QWebSocketServer::NonSecureMode) {
    QObject::connect(&server_, &QWebSocketServer::newConnection, &server_, [this] { welcome(); });
}

void RosbridgePort::welcome() {
    while (QWebSocket* socket = server_.nextPendingConnection()) {
        Client client{{socket, deleteSocketLater}, {}, false};
        if (clients_.size() >= kMostClients)
            continue;  // deleted with `client`
        socket->setMaxAllowedIncomingMessageSize(robot_link::kMostTextBytes);
        socket->setMaxAllowedIncomingFrameSize(robot_link::kMostTextBytes);
        QObject::connect(socket, &QWebSocket::textMessageReceived, socket,
                         [this, socket](const QString& text) { read(socket, text); });
        QObject::connect(socket, &QWebSocket::disconnected, socket,
                         [this, socket] { clients_.erase(socket); });
        clients_.emplace(socket, std::move(client));
    }
}

void RosbridgePort::read(QWebSocket* socket, const QString& text) {
    const auto operation = robot_link::readOperation(text.toStdString());
    const Status done = operation ? obey(clients_.at(socket), *operation) : Status(operation.error());
    if (!done)
        socket->sendTextMessage(QString::fromStdString(robot_link::statusText("error", done.error().text())));
}

Status RosbridgePort::obey(Client& client, const robot_link::RosOperation& operation) {
    if (operation.op == "advertise") {
        if (client.types.size() >= kMostTopics)
            return refused("too many topics are advertised");
        client.types[operation.topic] = operation.type;
    } else if (operation.op == "unadvertise") {
        client.types.erase(operation.topic);
    } else if (operation.op == "subscribe" || operation.op == "unsubscribe") {
        if (operation.topic != kStateTopic)
            return refused("there is no topic " + operation.topic + " but " + kStateTopic);
        client.hears_state = operation.op == "subscribe";
    } else if (operation.op == "publish") {
        const auto found = client.types.find(operation.topic);
        if (found == client.types.end())
            return refused("topic " + operation.topic + " was not advertised");
        return obeyMessage(found->second, operation);
    } else {
        return refused("operation " + operation.op + " is not known");
    }
    return Done{};
}

Status RosbridgePort::obeyMessage(const std::string& type, const robot_link::RosOperation& operation) {
    if (type == robot_link::kPoseStamped) {
        const auto tip = robot_link::readPoseStamped(operation.msg);
        if (!tip)
            return tip.error();
        const auto arm = std::ranges::find_if(arms_, [&](const std::string& name) {
            return operation.topic == "/noctule/" + name + "/pose_command" || arms_.size() == 1;
        });
        if (arm == arms_.end())
            return refused("topic " + operation.topic + " names no arm of this robot");
        body_.commandTip(steadyNow_ns(), static_cast<size_t>(arm - arms_.begin()),
                         tip->q_base_tip.toRotationMatrix(), tip->p_base_tip);
        return Done{};
    }
    const bool is_trajectory = type == robot_link::kJointTrajectory;
    if (!is_trajectory && type != robot_link::kJointState)
        return refused("type " + type + " is no command");
    const auto named = is_trajectory ? robot_link::readJointTrajectory(operation.msg)
                                     : robot_link::readJointState(operation.msg);
    if (!named)
        return named.error();
    std::vector<double> q, v;
    if (!robot_link::sortInto(body_.joints(), *named, q, v))
        return refused("a command does not name every joint of this robot");
    body_.command(steadyNow_ns(), ++sequence_, q);
    return Done{};
}

void RosbridgePort::tellState() {
    if (clients_.empty())
        return;
    const int64_t wall_ns = QDateTime::currentMSecsSinceEpoch() * 1'000'000;
    const QString text = QString::fromStdString(robot_link::publish(
        kStateTopic, robot_link::jointState(body_.joints(), body_.q(), body_.v(), wall_ns)));
    for (auto& [socket, client] : clients_)
        if (client.hears_state && socket->bytesToWrite() < kMostUnsentBytes)
            socket->sendTextMessage(text);
}

void RosbridgePort::setReachable(bool reachable) {
    if (reachable) {
        server_.listen(where_.host, where_.port);
        return;
    }
    clients_.clear();
    server_.close();
}

}  // namespace noctule::virtual_robot
