// SPDX-License-Identifier: Apache-2.0
// The studio's loop drives noctule-virtual-robot over loopback while everything breaks, one after the other.
// What is waited for is a state, never a time.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/robot/urdf_reader.h"
#include "devices/machine/clock.h"
#include "devices/robot/drive_loop.h"
#include "tests/support/plain_arm.h"

namespace noctule::virtual_robot {
namespace {

using robot::DriveTrouble;
using robot::TeleopState;

void writeText(const QString& path, const std::string& text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
}

/// The program, its addresses and its control port.
class Robot {
public:
    explicit Robot(const QString& interface) {
        const QString urdf = folder_.filePath("arm.urdf"), profile = folder_.filePath("arm.json");
        writeText(urdf, test::plainArmUrdf());
        writeText(profile, robot::toJson(test::plainArmProfile()).dump());
        process_.start(NOCTULE_PROGRAM, {"--robot", urdf, "--profile", profile, interface, "127.0.0.1:0",
                                         "--control", "127.0.0.1:0"});
        address = lineAfter("robot: ");
        const QString control = lineAfter("control: ");
        control_.connectToHost("127.0.0.1", control.section(':', -1).toUShort());
        EXPECT_TRUE(control_.waitForConnected(20'000));
    }
    ~Robot() {
        control_.write("quit\n");
        control_.waitForBytesWritten(20'000);
        EXPECT_TRUE(process_.waitForFinished(20'000));
        EXPECT_EQ(process_.exitCode(), 0);
    }
    void tell(const char* line) {
        control_.write((std::string(line) + "\n").c_str());
        while (!control_.canReadLine() && control_.waitForReadyRead(20'000)) {
        }
        EXPECT_EQ(control_.readLine().trimmed(), "ok") << line;
    }

    QString address;

private:
    QString lineAfter(const QString& beginning) {
        while (!process_.canReadLine() && process_.waitForReadyRead(20'000)) {
        }
        const QString line = process_.readLine().trimmed();
        EXPECT_TRUE(line.startsWith(beginning)) << line.toStdString();
        return line.mid(beginning.size());
    }

    QTemporaryDir folder_;
    QProcess process_;
    QTcpSocket control_;
};

/// Breaks one thing after the other and waits until it is noticed and over.
class Script {
public:
    Script(Robot& robot, robot_link::PoseFeed& feed) : robot_(robot), feed_(feed) {}

    bool ended() const { return at_ >= std::size(kActs); }
    std::string where() const { return ended() ? "the end" : kActs[at_].begin; }

    robot::TeleopKeys next(const robot::DriveOutput& output) {
        if (!ended())
            play(output);
        if (!suit_stalls_)
            feed_.put(pose(), steadyNow_ns());
        return {!lets_go_, !lets_go_, true, false, false};
    }

private:
    struct Act {
        const char *begin, *end;  ///< lines of the control port, or "suit" and "key" of this test
        DriveTrouble notice;
    };
    static constexpr Act kActs[] = {
        {"stall 0.4", "", DriveTrouble::kRobotSilent},
        {"cut 0.4", "", DriveTrouble::kRobotSilent},
        {"refuse", "accept", DriveTrouble::kRobotRefuses},
        {"joint-stuck e", "joint-free e", DriveTrouble::kJointOff},
        {"suit", "suit", DriveTrouble::kNoPose},
        {"key", "key", DriveTrouble::kNone},
        {"latency 60", "latency 0", DriveTrouble::kNone},
    };

    static constexpr int kFollowedBefore = 20;  ///< commands in a row that follow before each fault

    /// A JointState cannot say that it refuses: it shows as joints that do not follow.
    DriveTrouble noticeOf(const Act& act) const {
        const bool is_silent_refusal =
            act.notice == DriveTrouble::kRobotRefuses && robot_.address.startsWith("ws");
        return is_silent_refusal ? DriveTrouble::kJointOff : act.notice;
    }

    void play(const robot::DriveOutput& output) {
        const Act& act = kActs[at_];
        if (!begun_) {
            followed_ = output.state == TeleopState::kFollowing ? followed_ + 1 : 0;
            if (followed_ < kFollowedBefore)
                return;
            followed_ = 0;
            say(act.begin);
            begun_ = true;
        } else if (!noticed_) {
            const bool is_key = std::string(act.begin) == "key";
            noticed_ = is_key                              ? output.state == TeleopState::kHolding
                       : act.notice == DriveTrouble::kNone ? true
                                                           : output.trouble == noticeOf(act);
            if (noticed_)
                say(act.end);
        } else if (output.state == TeleopState::kFollowing) {
            begun_ = noticed_ = false;
            ++at_;
        }
    }
    void say(const std::string& what) {
        if (what == "suit")
            suit_stalls_ = !suit_stalls_;
        else if (what == "key")
            lets_go_ = !lets_go_;
        else if (!what.empty())
            robot_.tell(what.c_str());
    }
    TimedPose pose() {
        const Skeleton& skeleton = defaultActor().skeleton;
        Pose pose = skeleton.zeroPose();
        const double angle = 0.6 * std::sin(3e-9 * static_cast<double>(steadyNow_ns() % 1'000'000'000'000));
        const int upper = skeleton.find("RightArm"), forearm = skeleton.find("RightForeArm");
        EXPECT_GE(std::min(upper, forearm), 0);
        // The upper arm hangs, the forearm points ahead and swings.
        pose.q_parent_joint[static_cast<size_t>(upper)] = axisAngle(Vector3d::UnitZ(), radians(90));
        pose.q_parent_joint[static_cast<size_t>(forearm)] = axisAngle(Vector3d::UnitY(), radians(90) + angle);
        return {++count_, pose, {}};
    }

    Robot& robot_;
    robot_link::PoseFeed& feed_;
    size_t at_ = 0;
    int64_t count_ = 0;
    int followed_ = 0;
    bool begun_ = false, noticed_ = false, suit_stalls_ = false, lets_go_ = false;
};

class EveryInterface : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryInterface, HoldsThroughEveryFaultAndNeverJumps) {
    int argc = 1;
    char name[] = "test", *argv[] = {name, nullptr};
    const std::unique_ptr<QCoreApplication> application(
        QCoreApplication::instance() ? nullptr : new QCoreApplication(argc, argv));
    Robot robot(GetParam());
    const auto model = robot::parseUrdf(test::plainArmUrdf(), "arm");
    const robot::RobotProfile profile = test::plainArmProfile();
    const auto arms = robot::drivenParts(*model, profile, {});
    ASSERT_TRUE(arms);
    const auto performer = robot::PerformerArms::make(defaultActor().skeleton, "performer");
    ASSERT_TRUE(performer);
    robot_link::LinkOptions options;
    options.joints = arms->joints();
    const auto link = robot_link::makeInterface(robot.address.toStdString(), options);
    ASSERT_TRUE(link) << link.error().text();
    robot_link::PoseFeed feed(defaultActor().skeleton, *performer);
    Script script(robot, feed);
    robot::DriveSettings settings;
    settings.teleop.farthest_rad = 3;  // the blend is what is tested, not the performer's patience
    settings.teleop.blend_s = 0.2;
    std::string told;
    const double length_m = performer->armLength_m(robot::Side::kRight);
    const robot_link::DrivePlan plan{**link,
                                     feed,
                                     *model,
                                     profile,
                                     *arms,
                                     {length_m, length_m},
                                     settings,
                                     100,
                                     [&](const robot::DriveOutput& output) { return script.next(output); },
                                     [&] { return script.ended(); },
                                     [&](const std::string& sentence) { told += sentence + "\n"; },
                                     true};
    const auto report = robot_link::runDrive(plan, {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(script.ended()) << "stuck at " << script.where() << "\n" << told;
    EXPECT_LE(report->largest_speed_use, 1 + 1e-9);
    EXPECT_LE(report->longest_hold_s, 0.1 + 1.0 / 140);
    EXPECT_GT(report->following, 100) << "seven faults, 20 commands before each";
    EXPECT_GT(report->link.latency.count(), 100);
    EXPECT_NE(told.find("does not answer"), std::string::npos);
    const auto lines = std::count(report->table.begin(), report->table.end(), '\n');
    EXPECT_EQ(lines, report->commands + 1);
}

INSTANTIATE_TEST_SUITE_P(Robot, EveryInterface, ::testing::Values("--udp", "--rosbridge"),
                         [](const auto& one) { return std::string(one.param).substr(2); });

TEST(VirtualRobot, NoRobotIsSaid) {
    int argc = 1;
    char name[] = "test", *argv[] = {name, nullptr};
    const std::unique_ptr<QCoreApplication> application(
        QCoreApplication::instance() ? nullptr : new QCoreApplication(argc, argv));
    QProcess program;
    program.start(NOCTULE_PROGRAM, {"--robot", "/nowhere/robot.urdf", "--udp", "127.0.0.1:0"});
    ASSERT_TRUE(program.waitForFinished(20'000));
    EXPECT_EQ(program.exitCode(), 3);
    EXPECT_NE(program.readAllStandardError().indexOf("robot.urdf"), -1);
}

}  // namespace
}  // namespace noctule::virtual_robot
