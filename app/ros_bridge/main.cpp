// SPDX-License-Identifier: Apache-2.0
// noctule-ros-bridge: a robot of ROS 1 as a robot on our UDP interface (devices/robot/README.md). Commands
// become messages on a topic of a ROS master, the joint states of that master go back to the studio. Built
// where roscpp is installed. Commands pass through as they come: limits, watchdog and state machine are the
// studio's and the robot's.
#include <poll.h>

#include <algorithm>
#include <clocale>
#include <cstdio>

#include "app/batch/arguments.h"
#include "app/batch/console.h"
#include "app/batch/help.h"
#include "app/batch/robot_profiles.h"
#include "app/batch/signals.h"
#include "app/ros_bridge/joint_values.h"
#include "app/ros_bridge/ros_node.h"
#include "app/ros_bridge/udp_socket.h"
#include "core/robot/driven_parts.h"
#include "core/robot/urdf_reader.h"
#include "devices/machine/clock.h"
#include "devices/robot/datagram.h"

namespace noctule::ros_bridge {
namespace {

using batch::Arguments;
using robot_link::Datagram;
using robot_link::DatagramKind;

constexpr const char* kName = "noctule-ros-bridge";
constexpr const char* kExample = "noctule-ros-bridge --robot g1.urdf --udp 127.0.0.1:41950";
constexpr int kLookAtRos_ms = 1;

const std::vector<batch::Option>& optionTable() {
    using namespace batch;
    static const std::vector<Option> options = {
        text("robot", "R.urdf", "the robot; a xacro file has to be expanded first"),
        text("profile", "P.json", "which joints are its arms; else found by the robot's name or made"),
        armsOption(),
        trunkOption(),
        text("udp", "HOST:PORT", "listen there for the studio, port 0 for any free one")
            .orElse("127.0.0.1:41950"),
        choice("message", {"joint-state", "trajectory"},
               "sensor_msgs/JointState, or trajectory_msgs/JointTrajectory with one point")
            .orElse("joint-state"),
        text("topic", "NAME", "of the commands; else /noctule/joint_command or /noctule/joint_trajectory"),
        text("state-topic", "NAME", "sensor_msgs/JointState of the robot").orElse("/joint_states"),
        number("rate", "HZ", 1, 1000, "commands a second; a trajectory's point lies two of them ahead")
            .orElse("140"),
        flag("help", "this text")};
    return options;
}

std::string helpText() {
    return std::string(kName) +
           ": carries commands of `noctule --batch drive` into ROS 1, and the robot's state back.\n\n"
           "usage: noctule-ros-bridge --robot R.urdf [OPTIONS]\n\noptions:\n" +
           batch::optionList(optionTable()) +
           "\nThe master is found as every ROS program finds it: ROS_MASTER_URI. Works until Ctrl-C.\n\n" +
           batch::exitCodeLine(batch::standInExitCodes()) + "\nexample: " + kExample + "\n";
}

Result<Arguments> parseOptions(const std::vector<std::string>& words) {
    auto arguments = Arguments::parse(words, optionTable());
    if (arguments && (!arguments->operands().empty() || !arguments->given("robot")))
        return Error{ErrorKind::kUsage,
                     arguments->operands().empty() ? "no robot is given"
                                                   : "'" + arguments->operands()[0] + "' is no option",
                     std::string("Write for example: ") + kExample};
    return arguments;
}

Result<std::vector<std::string>> jointsOfRobot(const Arguments& arguments, const CancelFlag& cancel) {
    const auto model = robot::readUrdf(arguments.text("robot"), &cancel);
    if (!model)
        return model.error();
    const auto profile = batch::robotProfile(*model, arguments.text("profile"));
    if (!profile)
        return profile.error();
    const auto parts = robot::drivenParts(*model, *profile, batch::partsChoice(arguments));
    if (!parts)
        return parts.error();
    return parts->joints();
}

RosOptions rosOptionsOf(const Arguments& arguments, const std::vector<std::string>& joints) {
    RosOptions options;
    options.joints = joints;
    options.as_trajectory = arguments.text("message") == "trajectory";
    options.command_topic = arguments.given("topic") ? arguments.text("topic")
                            : options.as_trajectory  ? "/noctule/joint_trajectory"
                                                     : "/noctule/joint_command";
    options.state_topic = arguments.text("state-topic");
    options.ahead_s = 2 / *arguments.number("rate");
    return options;
}

class Bridge {
public:
    Bridge(const Arguments& arguments, std::vector<std::string> joints, UdpSocket socket)
        : joints_(std::move(joints)),
          joints_hash_(robot_link::hashOf(joints_)),
          socket_(std::move(socket)),
          values_(joints_),
          node_(rosOptionsOf(arguments, joints_), [this](const auto& names, const auto& q, const auto& v) {
              if (values_.take(names, q, v))
                  tellState();
          }) {}

    void run(const CancelFlag& cancel) {
        do {
            pollfd waiting{socket_.handle(), POLLIN, 0};
            if (::poll(&waiting, 1, kLookAtRos_ms) > 0)
                while (const auto bytes = socket_.receive())
                    obey(*bytes);
        } while (node_.spinOnce() && !cancel.cancelled());
    }

private:
    /// What cannot be read, or is for other joints, is ignored and said once.
    void obey(const std::vector<uint8_t>& bytes) {
        const auto read = robot_link::decode(bytes);
        if (!read)
            return sayOnce(read.error());
        if (read->kind == DatagramKind::kState)
            return;
        socket_.answerLast();
        if (read->kind == DatagramKind::kQuery)
            return tellState();
        if (read->joints_hash != joints_hash_ || read->q.size() != joints_.size())
            return sayOnce({ErrorKind::kUnusable, "the studio drives other joints than this bridge",
                            "Give both the same --robot, --profile, --arms and --trunk"});
        obeyed_ = read->sequence;
        node_.publish(read->q, read->v);
    }

    void tellState() {
        if (!values_.complete())
            return;
        Datagram state;
        state.kind = DatagramKind::kState;
        state.sequence = ++sequence_;
        state.time_ns = steadyNow_ns();
        state.joints_hash = joints_hash_;
        state.obeyed_sequence = obeyed_;
        state.q = values_.q();
        state.v = values_.v();
        socket_.send(robot_link::encode(state));
    }

    void sayOnce(const Error& error) {
        if (std::exchange(said_, error.message) != error.message)
            batch::Console(false, false, kName).warn(error.text());
    }

    const std::vector<std::string> joints_;
    const uint64_t joints_hash_;
    UdpSocket socket_;
    JointValues values_;
    RosNode node_;
    uint64_t sequence_ = 0, obeyed_ = 0;
    std::string said_;
};

int endWithError(const Error& error) {
    batch::Console(false, false, kName).error(error);
    return static_cast<int>(error.kind);
}

int runChecked(const std::vector<std::string>& words, const CancelFlag& cancel) {
    const auto arguments = parseOptions(words);
    if (!arguments)
        return endWithError(arguments.error());
    auto joints = jointsOfRobot(*arguments, cancel);
    if (!joints)
        return endWithError(joints.error());
    auto socket = UdpSocket::listen(arguments->text("udp"));
    if (!socket)
        return endWithError(socket.error());
    if (!RosNode::masterAnswers())
        return endWithError({ErrorKind::kDevice, RosNode::masterUri() + ": no ROS master answers",
                             "Start roscore, or set ROS_MASTER_URI to where it runs"});
    std::printf("robot: udp://%s\n", socket->address().c_str());
    std::fflush(stdout);
    Bridge bridge(*arguments, std::move(*joints), std::move(*socket));
    bridge.run(cancel);
    return cancel.cancelled() ? static_cast<int>(ErrorKind::kCancelled) : 0;
}

}  // namespace

int runBridge(int argc, char** argv) {
    const CancelFlag& cancel = batch::cancelOnSignals();
    RosNode::initialise(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (std::find(words.begin(), words.end(), "--help") != words.end()) {
        std::fputs(helpText().c_str(), stdout);
        return 0;
    }
    try {
        return runChecked(words, cancel);
    } catch (const std::exception& mistake) {
        return endWithError({ErrorKind::kInternal, std::string("internal error: ") + mistake.what(),
                             "Report it with the command line and the URDF"});
    }
}

}  // namespace noctule::ros_bridge

int main(int argc, char** argv) {
    return noctule::ros_bridge::runBridge(argc, argv);
}
