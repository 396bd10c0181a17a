// SPDX-License-Identifier: Apache-2.0
// The page "Robot" against noctule-virtual-robot, with a take that leads.
#pragma once

#include <gtest/gtest.h>

#include <QProcess>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/math/rotation.h"
#include "core/recording/take_edit.h"
#include "core/robot/urdf_reader.h"
#include "tests/support/plain_arm.h"
#include "tests/support/simulated_take.h"
#include "tests/ui/support/wait.h"
#include "ui/robot/robot_center.h"
#include "ui/robot/robot_page.h"
#include "ui/robot/robot_state_panel.h"
#include "ui/style/theme.h"
#include "ui/widgets/button.h"

namespace noctule::ui {

inline constexpr double kRate_hz = 100;

inline void writeFile(const QString& path, const std::string& text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
}

/// The upper arms hang and the forearms point ahead, as the robot's do at first; the right one swings.
inline MotionClip swingingForearm() {
    MotionClip clip;
    clip.name = "swing";
    clip.skeleton = defaultActor().skeleton;
    clip.frame_time_s = 1 / kRate_hz;
    const auto joint = [&](const char* name) { return static_cast<size_t>(clip.skeleton.find(name)); };
    for (int i = 0; i < 8 * kRate_hz; ++i) {
        Pose pose = clip.skeleton.zeroPose();
        pose.p_world_root.y() = 1;
        const double swing = 0.5 * (1 - std::cos(3 * i / kRate_hz));
        pose.q_parent_joint[joint("RightArm")] = axisAngle(Vector3d::UnitZ(), radians(90));
        pose.q_parent_joint[joint("RightForeArm")] = axisAngle(Vector3d::UnitY(), radians(90) + 0.6 * swing);
        pose.q_parent_joint[joint("LeftArm")] = axisAngle(Vector3d::UnitZ(), radians(-90));
        clip.frames.push_back(pose);
    }
    return clip;
}

/// A take that has these poses.
inline void makeTake(const std::string& path) {
    const MotionClip clip = swingingForearm();
    ASSERT_TRUE(noctule::test::writeSimulatedTake(path, {.clip = clip, .rest_seconds = 0}));
    Take take = Take::open(path, Access::kReadWrite).value();
    auto edit = TakeEdit::begin(take).value();
    const auto run = edit.beginRun({0, "pose", "truth", "", "test", "{}", 1, 1});
    ASSERT_TRUE(run);
    for (size_t i = 0; i < clip.frames.size(); ++i)
        ASSERT_TRUE(
            edit.addPose(*run, {std::llround(static_cast<double>(i) * 1e9 / kRate_hz), clip.frames[i], {}}));
    ASSERT_TRUE(edit.commit());
}

class RobotPageTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        QSettings().clear();
        QSettings().setValue("folders/sessions", folder_.filePath("sessions"));
        QSettings().setValue("folders/suits", folder_.filePath("suits"));
        urdf_ = folder_.filePath("arm.urdf");
        profile_ = folder_.filePath("arm.json");
        writeFile(urdf_, noctule::test::plainArmUrdf());
        writeFile(profile_, robot::toJson(noctule::test::plainArmProfile()).dump());
        studio_ = std::make_unique<Studio>(StudioParts{"test", [] { return std::string(); }, {}});
        drive_ = std::make_unique<RobotDrive>(*studio_);
        page_ = std::make_unique<RobotPage>(*studio_, *drive_);
        page_->resize(900, 700);
        page_->show();
        page_->leftDock()->show();
        page_->rightDock()->show();
        page_->enter();
    }
    void TearDown() override {
        drive_->removeRobot();
        delete page_->leftDock();
        delete page_->rightDock();
        page_.reset();
        drive_.reset();
        ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
        studio_.reset();
        if (program_.state() != QProcess::NotRunning) {
            control_.write("quit\n");
            control_.waitForBytesWritten(20'000);
            EXPECT_TRUE(program_.waitForFinished(20'000));
        }
    }

    QString lineAfter(const QString& beginning) {
        while (!program_.canReadLine() && program_.waitForReadyRead(20'000)) {
        }
        const QString line = program_.readLine().trimmed();
        EXPECT_TRUE(line.startsWith(beginning)) << line.toStdString();
        return line.mid(beginning.size());
    }
    void startRobot(const QString& interface, const QStringList& more = {}) {
        program_.start(NOCTULE_PROGRAM, QStringList{"--robot", urdf_, "--profile", profile_, interface,
                                                    "127.0.0.1:0", "--control", "127.0.0.1:0"} +
                                            more);
        address_ = lineAfter("robot: ");
        control_.connectToHost("127.0.0.1", lineAfter("control: ").section(':', -1).toUShort());
        ASSERT_TRUE(control_.waitForConnected(20'000));
    }
    void tell(const char* line) {
        control_.write((std::string(line) + "\n").c_str());
        while (!control_.canReadLine() && control_.waitForReadyRead(20'000)) {
        }
        EXPECT_EQ(control_.readLine().trimmed(), "ok") << line;
    }
    RobotChoice choice() const {
        RobotChoice choice;
        choice.urdf = urdf_;
        choice.profile = profile_;
        choice.address = address_;
        choice.body = DrivenBody::kRightArm;
        return choice;
    }
    bool comesTo(RobotWord word) {
        return waitFor([&] { return drive_->word() == word; });
    }
    void openTake() {
        const QString path = folder_.filePath("swing_001.noctule");
        makeTake(path.toStdString());
        studio_->take().open(path);
        ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().shownMotion(); }));
    }
    /// The take leads, and the robot follows it.
    void follow() {
        openTake();
        drive_->setLeader(RobotDrive::Leader::kTake);
        drive_->setRobot(choice());
        ASSERT_TRUE(waitFor([this] { return drive_->link() == RobotDrive::Link::kAnswers; }))
            << drive_->trouble().toStdString();
        QTest::keyPress(page_.get(), Qt::Key_F8);
        drive_->setClutch(true);
        ASSERT_TRUE(comesTo(RobotWord::kReady)) << page_->state().verdict().toStdString();
        page_->state().wayOn().click();
        ASSERT_TRUE(comesTo(RobotWord::kFollowing));
    }
    /// The operator lets the robot follow again whenever it held, as it may where no core was free for it.
    void acceptWhenReady() {
        if (drive_->word() == RobotWord::kReady)
            page_->state().wayOn().click();
    }
    bool followsAgainAfter(double seconds) {
        const double until_s = drive_->moments().back().time_s + seconds;
        return waitFor([&] {
            acceptWhenReady();
            return drive_->moments().back().time_s > until_s && drive_->word() == RobotWord::kFollowing;
        });
    }
    size_t momentsIn(double from_s, double to_s) const {
        return static_cast<size_t>(std::ranges::count_if(drive_->moments(), [&](const RobotMoment& moment) {
            return moment.time_s > from_s && moment.time_s <= to_s;
        }));
    }
    /// The largest speed of a joint from one command to the next, as a share of its limit.
    double largestSpeed() const {
        double largest = 0;
        const auto& moments = drive_->moments();
        for (size_t i = 1; i < moments.size(); ++i)
            for (size_t j = 0; j < moments[i].output.q.size(); ++j)
                largest = std::max(largest, std::abs(moments[i].output.q[j] - moments[i - 1].output.q[j]) *
                                                140 / noctule::test::kPlainArmSpeed);
        return largest;
    }

    QTemporaryDir folder_;
    QString urdf_, profile_, address_;
    QProcess program_;
    QTcpSocket control_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<RobotDrive> drive_;
    std::unique_ptr<RobotPage> page_;
};

}  // namespace noctule::ui
