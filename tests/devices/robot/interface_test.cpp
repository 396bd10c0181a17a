// SPDX-License-Identifier: Apache-2.0
// Both interfaces against a robot of the test's own, over loopback.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QNetworkDatagram>
#include <QUdpSocket>
#include <QWebSocket>
#include <QWebSocketServer>

#include "devices/machine/clock.h"
#include "devices/robot/datagram.h"
#include "devices/robot/robot_interface.h"
#include "devices/robot/ros_messages.h"

namespace noctule::robot_link {
namespace {

const std::vector<std::string> kJoints{"shoulder", "elbow"};

LinkOptions twoJoints() {
    LinkOptions options;
    options.joints = kJoints;
    return options;
}

/// Generous, so that a slow machine passes; a condition that comes true ends the wait at once.
template <class Condition>
bool waitFor(Condition condition) {
    const QDeadlineTimer end(20'000);
    while (!condition()) {
        if (end.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    return true;
}

RobotCommand commandOf(uint64_t sequence) {
    RobotCommand command;
    command.sequence = sequence;
    command.time_ns = command.pose_arrived_ns = steadyNow_ns();
    command.flags = kFollows;
    command.q = {0.1, -0.2};
    command.v = {0, 0.5};
    return command;
}

class UdpRobot {
public:
    UdpRobot() { EXPECT_TRUE(socket.bind(QHostAddress(QHostAddress::LocalHost), 0)); }
    std::string address() const { return "udp://127.0.0.1:" + std::to_string(socket.localPort()); }
    std::optional<Datagram> next(DatagramKind kind) {
        std::optional<Datagram> found;
        waitFor([&] {
            while (socket.hasPendingDatagrams() && !found) {
                const QNetworkDatagram datagram = socket.receiveDatagram();
                studio = datagram;
                const QByteArray bytes = datagram.data();
                const auto read = decode(
                    {reinterpret_cast<const uint8_t*>(bytes.constData()), static_cast<size_t>(bytes.size())});
                if (read && read->kind == kind)
                    found = *read;
            }
            return found.has_value();
        });
        return found;
    }
    void tell(const Datagram& state) { tellBytes(encode(state)); }
    void tellBytes(const std::vector<uint8_t>& bytes) {
        socket.writeDatagram(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()),
                             studio.senderAddress(), static_cast<quint16>(studio.senderPort()));
    }

    QUdpSocket socket;
    QNetworkDatagram studio;
};

Datagram stateOf(uint64_t sequence, double shoulder) {
    Datagram state;
    state.kind = DatagramKind::kState;
    state.sequence = sequence;
    state.joints_hash = hashOf(kJoints);
    state.q = {shoulder, 0};
    state.v = {0, 0};
    return state;
}

TEST(UdpInterface, AsksCommandsAndHears) {
    UdpRobot robot;
    const auto link = makeInterface(robot.address(), twoJoints());
    ASSERT_TRUE(link) << link.error().text();
    (*link)->open();
    const auto query = robot.next(DatagramKind::kQuery);
    ASSERT_TRUE(query);
    EXPECT_EQ(query->joints_hash, hashOf(kJoints));
    robot.tell(stateOf(1, 0.75));
    ASSERT_TRUE(waitFor([&] { return (*link)->status().state.has_value(); }));
    EXPECT_EQ((*link)->status().state->q[0], 0.75);

    (*link)->send(commandOf(9));
    const auto command = robot.next(DatagramKind::kCommand);
    ASSERT_TRUE(command);
    EXPECT_EQ(command->sequence, 9u);
    EXPECT_EQ(command->q, (std::vector<double>{0.1, -0.2}));
    EXPECT_EQ(command->v, (std::vector<double>{0, 0.5}));
    EXPECT_EQ(command->flags, uint32_t{kFollows});
    ASSERT_TRUE(waitFor([&] { return (*link)->status().latency.count() == 1; }));
}

TEST(UdpInterface, OldDamagedAndForeignStatesDoNotCount) {
    UdpRobot robot;
    const auto link = makeInterface(robot.address(), twoJoints());
    ASSERT_TRUE(link) << link.error().text();
    (*link)->open();
    ASSERT_TRUE(robot.next(DatagramKind::kQuery));
    robot.tell(stateOf(5, 0.5));
    robot.tell(stateOf(4, 0.4));
    robot.tellBytes({1, 2, 3});
    Datagram foreign = stateOf(6, 0.6);
    foreign.joints_hash = hashOf({"wheel", "wing"});
    robot.tell(foreign);
    ASSERT_TRUE(waitFor([&] { return (*link)->status().refused_messages == 2; }));
    const LinkStatus status = (*link)->status();
    EXPECT_EQ(status.state->q[0], 0.5);
    EXPECT_EQ(status.states, 1);
    ASSERT_TRUE(status.trouble);
    EXPECT_NE(status.trouble->message.find("joints are others"), std::string::npos);
    robot.tell(stateOf(7, 0.7));
    ASSERT_TRUE(waitFor([&] { return (*link)->status().states == 2; }));
    EXPECT_FALSE((*link)->status().trouble) << "a good state ends the trouble";
}

/// A rosbridge server that keeps what it hears.
class RosRobot {
public:
    explicit RosRobot(quint16 port = 0) : server("test", QWebSocketServer::NonSecureMode) {
        QObject::connect(&server, &QWebSocketServer::newConnection, &server, [this] {
            client.reset(server.nextPendingConnection());
            QObject::connect(client.get(), &QWebSocket::textMessageReceived, client.get(),
                             [this](const QString& text) {
                                 const auto read = readOperation(text.toStdString());
                                 EXPECT_TRUE(read);
                                 if (read)
                                     heard.push_back(*read);
                             });
        });
        EXPECT_TRUE(server.listen(QHostAddress::LocalHost, port));
    }
    std::string address() const { return "ws://127.0.0.1:" + std::to_string(server.serverPort()); }
    bool hasHeard(const std::string& op, const std::string& topic) const {
        return std::any_of(heard.begin(), heard.end(),
                           [&](const RosOperation& o) { return o.op == op && o.topic == topic; });
    }
    void tell(const std::string& text) {
        client->sendTextMessage(QString::fromStdString(text));
        client->flush();
    }

    QWebSocketServer server;
    std::unique_ptr<QWebSocket> client;
    std::vector<RosOperation> heard;
};

TEST(RosbridgeInterface, AdvertisesSubscribesPublishes) {
    for (const RosCommand kind : {RosCommand::kJointState, RosCommand::kJointTrajectory, RosCommand::kPose}) {
        RosRobot robot;
        LinkOptions options = twoJoints();
        options.ros_command = kind;
        options.arms = {"right"};
        const char* topic = kind == RosCommand::kJointState        ? "/noctule/joint_command"
                            : kind == RosCommand::kJointTrajectory ? "/noctule/joint_trajectory"
                                                                   : "/noctule/right/pose_command";
        const auto link = makeInterface(robot.address(), options);
        ASSERT_TRUE(link) << link.error().text();
        (*link)->open();
        ASSERT_TRUE(waitFor([&] { return robot.hasHeard("subscribe", "/joint_states"); }));
        EXPECT_TRUE(robot.hasHeard("advertise", topic));
        robot.tell(publish("/joint_states", jointState({"wheel", "elbow"}, {9, 0.25}, {0, 0}, 1)));
        robot.tell(publish("/joint_states", jointState({"shoulder"}, {0.5}, {0}, 2)));
        ASSERT_TRUE(waitFor([&] { return (*link)->status().state.has_value(); }));
        EXPECT_EQ((*link)->status().state->q, (std::vector<double>{0.5, 0.25}));
        RobotCommand command = commandOf(1);
        command.tips = {{"right", "torso", {1, 2, 3}, Quaterniond::Identity()}};
        ASSERT_TRUE(waitFor([&] { return (*link)->status().is_connected; }));
        (*link)->send(command);
        ASSERT_TRUE(waitFor([&] { return robot.hasHeard("publish", topic); }));
        const nlohmann::json& msg = robot.heard.back().msg;
        if (kind == RosCommand::kPose)
            EXPECT_EQ(readPoseStamped(msg)->p_base_tip, Vector3d(1, 2, 3));
        else
            EXPECT_EQ((msg.contains("points") ? readJointTrajectory(msg) : readJointState(msg))->q,
                      command.q);
    }
}

TEST(RosbridgeInterface, ConnectsAgainWhenTheOtherEndIsBack) {
    auto robot = std::make_unique<RosRobot>();
    const quint16 port = robot->server.serverPort();
    const auto link = makeInterface(robot->address(), twoJoints());
    ASSERT_TRUE(link) << link.error().text();
    (*link)->open();
    ASSERT_TRUE(waitFor([&] { return (*link)->status().is_connected; }));
    robot.reset();
    ASSERT_TRUE(waitFor([&] { return !(*link)->status().is_connected; }));
    ASSERT_TRUE((*link)->status().trouble);
    (*link)->send(commandOf(1));
    ASSERT_TRUE(waitFor([&] { return (*link)->status().dropped == 1; }));
    robot = std::make_unique<RosRobot>(port);
    ASSERT_TRUE(waitFor([&] { return (*link)->status().reconnections == 1; }));
    ASSERT_TRUE(waitFor([&] { return robot->hasHeard("subscribe", "/joint_states"); }));
}

TEST(RosbridgeInterface, WrongMessagesAreCountedAndNamed) {
    RosRobot robot;
    const auto link = makeInterface(robot.address(), twoJoints());
    ASSERT_TRUE(link) << link.error().text();
    (*link)->open();
    ASSERT_TRUE(waitFor([&] { return robot.hasHeard("subscribe", "/joint_states"); }));
    for (const std::string& text :
         {std::string("hello"), publish("/joint_states", {{"name", 3}}),
          publish("/joint_states", jointState({"elbow"}, {1}, {0}, 1)), statusText("error", "no such type")})
        robot.tell(text);
    ASSERT_TRUE(waitFor([&] { return (*link)->status().refused_messages == 4; }));
    EXPECT_FALSE((*link)->status().state);
    EXPECT_NE((*link)->status().trouble->message.find("no such type"), std::string::npos);
    robot.tell("{\"op\":\"" + std::string(2 * kMostTextBytes, 'a') + "\"}");
    EXPECT_TRUE(waitFor([&] { return (*link)->status().reconnections >= 1; })) << "too long: begun anew";
}

/// Neither making nor opening waits for the network: the error comes by itself.
TEST(MakeInterface, ANameThatNoNetworkKnowsIsSaid) {
    for (const char* address : {"udp://no-such-robot.invalid:41950", "ws://no-such-robot.invalid:9090"}) {
        const auto link = makeInterface(address, twoJoints());
        ASSERT_TRUE(link) << "made without asking the network: " << link.error().text();
        (*link)->open();
        EXPECT_FALSE((*link)->status().is_connected);
        ASSERT_TRUE(waitFor([&] { return (*link)->status().is_hopeless; })) << address;
        const auto trouble = (*link)->status().trouble;
        ASSERT_TRUE(trouble);
        EXPECT_NE(trouble->message.find(address), std::string::npos);
        EXPECT_NE(trouble->message.find("knows no computer of this name"), std::string::npos);
    }
}

TEST(MakeInterface, AnUnansweredNameCanBeLetGo) {
    const auto link = makeInterface("udp://no-such-robot.invalid:41950", twoJoints());
    ASSERT_TRUE(link);
    (*link)->open();
    (*link)->send(commandOf(1));  // nothing is known yet: dropped or refused, never a wait
}

TEST(UdpInterface, ANameIsLookedUp) {
    UdpRobot robot;
    const std::string address = robot.address();
    const auto link = makeInterface("udp://localhost" + address.substr(address.rfind(':')), twoJoints());
    ASSERT_TRUE(link) << link.error().text();
    (*link)->open();
    ASSERT_TRUE(robot.next(DatagramKind::kQuery));
    robot.tell(stateOf(1, 0.75));
    EXPECT_TRUE(waitFor([&] { return (*link)->status().state.has_value(); }));
}

TEST(MakeInterface, NamesWhatIsWrong) {
    for (const char* address : {"", "udp://", "udp://127.0.0.1", "tcp://127.0.0.1:9", "127.0.0.1:9090",
                                "ws://127.0.0.1:99999", "ws://:9090"}) {
        const auto link = makeInterface(address, twoJoints());
        ASSERT_FALSE(link) << address;
        EXPECT_EQ(link.error().kind, ErrorKind::kUsage);
        EXPECT_NE(link.error().remedy.find("udp://HOST:PORT"), std::string::npos);
    }
    LinkOptions none;
    EXPECT_FALSE(makeInterface("udp://127.0.0.1:9", none));
}

}  // namespace
}  // namespace noctule::robot_link
