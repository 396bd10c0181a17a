// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/rosbridge_interface.h"

#include <QDateTime>
#include <QNetworkProxy>
#include <algorithm>

#include "devices/machine/clock.h"

namespace noctule::robot_link {
namespace {

/// Bytes that may wait for a slow network; what comes then is dropped, since an old command is of no use.
constexpr qint64 kMostUnsentBytes = 64 * 1024;
constexpr double kPeriodsAhead = 2;

int64_t wallNow_ns() {
    return QDateTime::currentMSecsSinceEpoch() * 1'000'000;
}

}  // namespace

const char* messageType(RosCommand command) {
    switch (command) {
        case RosCommand::kJointTrajectory:
            return kJointTrajectory;
        case RosCommand::kPose:
            return kPoseStamped;
        case RosCommand::kJointState:
            break;
    }
    return kJointState;
}

std::string commandTopic(const LinkOptions& options, const std::string& arm) {
    if (!options.command_topic.empty())
        return options.ros_command == RosCommand::kPose && options.arms.size() > 1
                   ? options.command_topic + "/" + arm
                   : options.command_topic;
    switch (options.ros_command) {
        case RosCommand::kJointTrajectory:
            return "/noctule/joint_trajectory";
        case RosCommand::kPose:
            return "/noctule/" + arm + "/pose_command";
        case RosCommand::kJointState:
            break;
    }
    return "/noctule/joint_command";
}

RosbridgeInterface::RosbridgeInterface(std::string address, QUrl url, LinkOptions options)
    : address_(std::move(address)), url_(std::move(url)), options_(std::move(options)) {
    state_.q.assign(options_.joints.size(), 0);
    state_.v = state_.q;
    known_.assign(options_.joints.size(), false);
    thread_ = std::make_unique<LoopThread>("robot", [this] {
        if (socket_)
            socket_->disconnect();  // its end is no reason to connect again
        socket_.reset();
        again_.reset();
    });
}

void RosbridgeInterface::open() {
    thread_->post([this] {
        again_ = std::make_unique<QTimer>();
        again_->setSingleShot(true);
        QObject::connect(again_.get(), &QTimer::timeout, again_.get(), [this] { connectSocket(); });
        connectSocket();
    });
}

void RosbridgeInterface::connectSocket() {
    if (socket_) {
        socket_->disconnect();
        socket_.release()->deleteLater();  // this may run inside one of its own signals
    }
    socket_ = std::make_unique<QWebSocket>();
    socket_->setProxy(QNetworkProxy::NoProxy);
    socket_->setMaxAllowedIncomingMessageSize(kMostTextBytes);
    socket_->setMaxAllowedIncomingFrameSize(kMostTextBytes);
    QObject::connect(socket_.get(), &QWebSocket::connected, socket_.get(), [this] { greet(); });
    QObject::connect(socket_.get(), &QWebSocket::textMessageReceived, socket_.get(),
                     [this](const QString& text) { read(text); });
    QObject::connect(socket_.get(), &QWebSocket::binaryMessageReceived, socket_.get(), [this] {
        book_.refused({ErrorKind::kUnreadable, address_ + ": sends binary messages",
                       "Run rosbridge without compression, as JSON"});
    });
    QObject::connect(socket_.get(), &QWebSocket::disconnected, socket_.get(), [this] {
        const std::string reason = socket_->closeReason().toStdString();
        retry(reason.empty() ? "the connection is closed" : reason);
    });
    QObject::connect(socket_.get(), QOverload<QAbstractSocket::SocketError>::of(&QWebSocket::error),
                     socket_.get(), [this](QAbstractSocket::SocketError error) {
                         if (error == QAbstractSocket::HostNotFoundError)
                             return giveUp();
                         retry(socket_->errorString().toStdString());
                     });
    again_->start(kConnectTime_ms);  // a connection that does not come about
    socket_->open(url_);
}

void RosbridgeInterface::greet() {
    again_->stop();
    was_connected_ = true;
    const char* type = messageType(options_.ros_command);
    if (options_.ros_command == RosCommand::kPose)
        for (const std::string& arm : options_.arms)
            socket_->sendTextMessage(QString::fromStdString(advertise(commandTopic(options_, arm), type)));
    else
        socket_->sendTextMessage(QString::fromStdString(advertise(commandTopic(options_), type)));
    socket_->sendTextMessage(QString::fromStdString(subscribe(options_.state_topic, kJointState)));
    book_.connected();
}

/// A name that was known once may be missing for a while.
void RosbridgeInterface::giveUp() {
    if (was_connected_)
        return retry("the network does not know its name now");
    again_->stop();
    gave_up_ = true;
    book_.hopeless(unknownName(address_));
}

void RosbridgeInterface::retry(const std::string& why) {
    if (gave_up_)
        return;
    book_.lost({ErrorKind::kDevice, address_ + ": no rosbridge answers: " + why,
                "Start rosbridge on the robot, and check its address and port (9090 is usual)"});
    again_->start(kAgain_ms);
}

void RosbridgeInterface::send(const RobotCommand& command) {
    require(areSound(command.q, command.v, options_.joints.size()),
            "a command has a finite value for every joint");
    if (book_.put(command))
        thread_->post([this] { write(); });
}

void RosbridgeInterface::write() {
    const auto command = book_.takeCommand();
    if (!command)
        return;
    if (!socket_ || !socket_->isValid() || socket_->bytesToWrite() > kMostUnsentBytes)
        return book_.dropped();
    const int64_t wall_ns = wallNow_ns();
    const auto put = [&](const std::string& arm, const nlohmann::json& msg) {
        socket_->sendTextMessage(QString::fromStdString(publish(commandTopic(options_, arm), msg)));
    };
    switch (options_.ros_command) {
        case RosCommand::kJointState:
            put({}, jointState(options_.joints, command->q, command->v, wall_ns));
            break;
        case RosCommand::kJointTrajectory:
            put({}, jointTrajectory(options_.joints, *command, kPeriodsAhead * options_.period_s, wall_ns));
            break;
        case RosCommand::kPose:
            for (const TipPose& tip : command->tips)
                put(tip.arm, poseStamped(tip, wall_ns));
            break;
    }
    socket_->flush();
    book_.sent(*command, steadyNow_ns());
}

void RosbridgeInterface::read(const QString& text) {
    const auto operation = readOperation(text.toStdString());
    if (!operation)
        return book_.refused(
            {operation.error().kind, address_ + ": " + operation.error().message, operation.error().remedy});
    if (operation->op == "publish" && operation->topic == options_.state_topic)
        return readState(operation->msg);
    if (operation->op == "status" && operation->msg.is_string())
        book_.refused({ErrorKind::kDevice,
                       address_ + ": rosbridge says: " + operation->msg.get<std::string>().substr(0, 300),
                       "Check the topics and their types"});
}

/// A robot may tell its joints in several messages; the state is whole once each has come.
void RosbridgeInterface::readState(const nlohmann::json& msg) {
    const auto named = readJointState(msg);
    if (!named)
        return book_.refused(
            {named.error().kind, address_ + ": " + named.error().message, named.error().remedy});
    sortInto(options_.joints, *named, state_.q, state_.v);
    bool is_ours = false;
    for (size_t i = 0; i < options_.joints.size(); ++i)
        if (std::ranges::find(named->names, options_.joints[i]) != named->names.end())
            known_[i] = is_ours = true;
    const auto missing = std::ranges::find(known_, false);
    if (missing != known_.end())
        return book_.refused({ErrorKind::kUnusable,
                              address_ + ": " + options_.state_topic + " has no joint \"" +
                                  options_.joints[static_cast<size_t>(missing - known_.begin())] + "\"",
                              "Check that the URDF is this robot's, and the topic of its state"});
    if (!is_ours)
        return;
    state_.time_ns = named->wall_ns;
    book_.received(state_, steadyNow_ns());
}

}  // namespace noctule::robot_link
