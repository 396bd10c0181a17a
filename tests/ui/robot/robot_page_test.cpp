// SPDX-License-Identifier: Apache-2.0
// The page "Robot" against noctule-virtual-robot: a take leads an arm, the operator's keys let it move and
// hold, faults of the robot are said. What is waited for is a state, never a time.
#include "ui/robot/robot_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPainter>
#include <QProcess>
#include <QSlider>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/math/rotation.h"
#include "core/recording/take_edit.h"
#include "core/robot/urdf_reader.h"
#include "tests/devices/support/test_box.h"
#include "tests/support/plain_arm.h"
#include "tests/support/simulated_take.h"
#include "tests/ui/support/wait.h"
#include "ui/robot/add_robot_dialog.h"
#include "ui/robot/key_card.h"
#include "ui/robot/robot_center.h"
#include "ui/robot/robot_sidebar.h"
#include "ui/robot/robot_state_panel.h"
#include "ui/robot/robot_view.h"
#include "ui/robot/robot_words.h"
#include "ui/style/theme.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

constexpr double kRate_hz = 100;

void writeFile(const QString& path, const std::string& text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
}

/// The upper arms hang and the forearms point ahead, as the robot's do at first; the right one swings.
MotionClip swingingForearm() {
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
void makeTake(const std::string& path) {
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

TEST_F(RobotPageTest, ATakeLeadsTheRobotWhileTheKeyIsHeld) {
    startRobot("--udp", {"--latency-ms", "80"});
    follow();
    page_->center().play();
    ASSERT_TRUE(waitFor([this] { return drive_->handPaths(0).tracking.has_value(); }));
    ASSERT_TRUE(waitFor([this] { return page_->center().figure(1) != QStringLiteral("–"); }));
    ASSERT_TRUE(followsAgainAfter(3));
    const auto tracking = drive_->handPaths(0).tracking;
    ASSERT_TRUE(tracking);
    EXPECT_GT(tracking->delay_s, 0.08) << "80 ms until a command is heard, and 20 ms of lag";
    EXPECT_LT(tracking->rest_rms_m, tracking->apart_rms_m);
    EXPECT_LE(largestSpeed(), 0.4 * 1.0001) << "the slider stands at 40 %";
    EXPECT_GT(largestSpeed(), 0.05) << "it moved";

    QTest::keyRelease(page_.get(), Qt::Key_F8);
    ASSERT_TRUE(comesTo(RobotWord::kHolding));
    EXPECT_EQ(drive_->holdingReason(), "key released");
    EXPECT_FALSE(drive_->table().isEmpty());
    EXPECT_TRUE(drive_->table().startsWith("time_s,"));
}

TEST_F(RobotPageTest, ADriveIsRecordedIntoTheTakeThatLeads) {
    startRobot("--udp", {"--latency-ms", "80"});
    EXPECT_FALSE(page_->center().record().isEnabled()) << "nobody leads";
    follow();
    page_->center().play();
    ASSERT_TRUE(waitFor([this] { return page_->center().record().isEnabled(); }));
    EXPECT_EQ(page_->center().record().text(), "Record");
    EXPECT_FALSE(page_->center().showsRecorded().isEnabled()) << "nothing was recorded yet";
    page_->center().record().click();
    ASSERT_TRUE(drive_->isRecording());
    EXPECT_EQ(page_->center().record().text(), "Stop recording");
    ASSERT_TRUE(followsAgainAfter(0)) << "what was commanded before the click is told";
    const double from_s = drive_->moments().back().time_s;
    ASSERT_TRUE(followsAgainAfter(3));
    const double to_s = drive_->moments().back().time_s;
    page_->center().record().click();
    EXPECT_FALSE(drive_->isRecording());
    EXPECT_EQ(drive_->word(), RobotWord::kFollowing) << "the robot goes on";
    ASSERT_TRUE(followsAgainAfter(0.1)) << "the keys are still held";
    ASSERT_TRUE(waitFor([this] { return !drive_->recordedPaths().commanded.empty(); }));
    ASSERT_TRUE(drive_->recordedPaths().tracking);
    EXPECT_GT(drive_->recordedPaths().tracking->delay_s, 0.08);
    page_->center().showsRecorded().click();
    EXPECT_NE(page_->center().figure(3), QStringLiteral("–"));
    const auto take = Take::open(folder_.filePath("swing_001.noctule").toStdString());
    ASSERT_TRUE(take);
    const auto drives = take->robotDrives();
    ASSERT_TRUE(drives);
    ASSERT_EQ(drives->size(), 1U);
    EXPECT_EQ(drives->front().leader, "take");
    EXPECT_GE(take->robotCommands(drives->front())->size(), momentsIn(from_s, to_s));
}

TEST_F(RobotPageTest, ATakeOfTheSuitThatLeadsHoldsTheRobotToo) {
    startRobot("--udp");
    const TestBox box({.loops = true});
    const Take tiny = std::move(Take::open(noctule::test::kTinyTake).value());
    LiveSuit& suit = studio_->suit();
    suit.connectTo(QString::fromStdString(box.address()),
                   {tiny.calibrationInForce()->value, tiny.actorInForce()->value, 0.5});
    ASSERT_TRUE(waitFor([&] { return suit.phase() == LiveSuit::Phase::kLooking; }));
    drive_->setRobot(choice());
    ASSERT_TRUE(waitFor([this] { return drive_->link() == RobotDrive::Link::kAnswers; }));
    ASSERT_TRUE(waitFor([this] { return drive_->whyNoLeader().isEmpty(); }));
    EXPECT_FALSE(drive_->isRecording());
    EXPECT_EQ(drive_->whyNotRecord(), "The suit leads: its recording holds the robot’s commands, too.");

    ASSERT_EQ(suit.record({"led", {}}), QString());
    ASSERT_TRUE(waitFor([this] { return drive_->isRecording(); })) << "by itself";
    ASSERT_TRUE(waitFor([&] { return suit.recordedSeconds() > 1.5; }));
    suit.stopRecording();
    ASSERT_TRUE(waitFor([this] { return !drive_->isRecording(); }));
    ASSERT_TRUE(waitFor([&] { return suit.phase() == LiveSuit::Phase::kLooking; }));
    EXPECT_EQ(drive_->link(), RobotDrive::Link::kAnswers) << "the robot goes on";
    ASSERT_TRUE(waitFor([this] { return !drive_->recordedPaths().commanded.empty(); }));

    const Session& session = studio_->session().session();
    ASSERT_EQ(session.takes.size(), 1U);
    const auto take = Take::open(session.pathOf(session.takes[0]).string());
    ASSERT_TRUE(take);
    const auto drives = take->robotDrives();
    ASSERT_TRUE(drives);
    ASSERT_EQ(drives->size(), 1U);
    EXPECT_EQ(drives->front().leader, "suit");
    EXPECT_EQ(drives->front().joints, drive_->parts()->joints);
    const auto commands = take->robotCommands(drives->front());
    ASSERT_TRUE(commands);
    ASSERT_GT(commands->size(), 100U) << "140 a second";
    const double length_s = take->duration_s().value();
    int led = 0;
    for (const RobotCommandRow& command : *commands)
        if (command.pose_time_ns) {
            ++led;
            EXPECT_GE(static_cast<double>(*command.pose_time_ns) * 1e-9, -1) << "on the take's clock";
            EXPECT_LE(static_cast<double>(*command.pose_time_ns) * 1e-9, length_s + 1);
        }
    EXPECT_GT(led, 0);
}

TEST_F(RobotPageTest, ANameThatNobodyKnowsIsSaidAndTheScreenGoesOn) {
    address_ = "udp://no-such-robot.invalid:41950";
    drive_->setRobot(choice());
    ASSERT_TRUE(waitFor([this] { return !drive_->trouble().isEmpty(); }));
    EXPECT_TRUE(drive_->trouble().contains("no-such-robot.invalid")) << drive_->trouble().toStdString();
    EXPECT_EQ(drive_->link(), RobotDrive::Link::kOff);
    drive_->setRobot(choice());
    drive_->disconnectRobot();  // the cancel: at once, whatever the network does
    EXPECT_EQ(drive_->link(), RobotDrive::Link::kOff);
}

TEST_F(RobotPageTest, StopEndsEverythingUntilItIsReleased) {
    startRobot("--rosbridge");
    follow();
    QTest::mousePress(&page_->center().stopKey(), Qt::LeftButton);
    QTest::mouseRelease(&page_->center().stopKey(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return drive_->holdingReason() == "stopped"; }));
    drive_->setDeadMan(true);
    drive_->setClutch(true);
    QTest::qWait(200);
    EXPECT_EQ(drive_->holdingReason(), "stopped") << "keys alone do not lead out";
    page_->state().wayOn().click();  // "Release the stop"
    ASSERT_TRUE(waitFor([this] { return drive_->word() != RobotWord::kHolding; }));
}

TEST_F(RobotPageTest, TheKeyCountsAsReleasedWhenTheWindowLosesTheKeyboard) {
    startRobot("--udp");
    follow();
    QEvent away(QEvent::WindowDeactivate);
    QCoreApplication::sendEvent(page_.get(), &away);
    EXPECT_FALSE(drive_->deadMan());
    ASSERT_TRUE(comesTo(RobotWord::kHolding));
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_F8, Qt::NoModifier, {}, true);
    QCoreApplication::sendEvent(page_.get(), &repeated);
    EXPECT_FALSE(drive_->deadMan()) << "a key that repeats was pressed before";
    page_->leave();
    EXPECT_FALSE(drive_->clutch());
}

TEST_F(RobotPageTest, FaultsOfTheRobotAreSaid) {
    startRobot("--udp");
    follow();
    tell("stall 100");
    ASSERT_TRUE(waitFor([this] { return page_->state().verdict().contains("does not answer"); }))
        << page_->state().verdict().toStdString();
    EXPECT_EQ(drive_->word(), RobotWord::kHolding);
    EXPECT_TRUE(waitFor([this] { return drive_->link() == RobotDrive::Link::kSilent; }));
}

TEST_F(RobotPageTest, ARobotThatIsNotThereIsSaid) {
    address_ = "udp://127.0.0.1:9";
    drive_->setRobot(choice());
    ASSERT_TRUE(waitFor([this] { return !drive_->trouble().isEmpty(); }));
    EXPECT_EQ(drive_->link(), RobotDrive::Link::kOff);
    EXPECT_TRUE(drive_->trouble().contains("127.0.0.1:9")) << drive_->trouble().toStdString();
    drive_->disconnectRobot();
    EXPECT_EQ(drive_->trouble(), "") << "nobody wants it any more";
}

TEST_F(RobotPageTest, JointsAreHeadedOnceARobotIsChosen) {
    const auto isHeaded = [this] {
        const auto labels = page_->state().findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text() == "achieved, commanded";
        });
    };
    EXPECT_FALSE(isHeaded());
    address_ = "udp://127.0.0.1:9";
    drive_->setRobot(choice());
    EXPECT_TRUE(waitFor([&] { return drive_->parts() && isHeaded(); }));
    drive_->removeRobot();
    EXPECT_FALSE(isHeaded());
}

TEST_F(RobotPageTest, AUrdfThatCannotBeReadIsSaid) {
    writeFile(urdf_, "<robot name=\"no\">");
    address_ = "udp://127.0.0.1:9";
    drive_->setRobot(choice());
    ASSERT_TRUE(waitFor([this] { return !drive_->trouble().isEmpty(); }));
    EXPECT_TRUE(drive_->trouble().contains("arm.urdf"));
    EXPECT_FALSE(drive_->parts());
}

TEST_F(RobotPageTest, TheDialogRefusesWhatCannotBe) {
    AddRobotDialog dialog({});
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Rejected) << "no URDF";
    dialog.setUrdf(urdf_ + "x");
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Rejected) << "no such file";
    dialog.setUrdf(urdf_);
    dialog.setAddress("udp://nowhere");
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Rejected) << "no port";
    dialog.setAddress("udp://127.0.0.1:41950");
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(dialog.choice().address, "udp://127.0.0.1:41950");
}

TEST_F(RobotPageTest, TheChoiceIsKept) {
    RobotChoice kept = choice();
    kept.speed = 0.7;
    kept.follows_posture = false;
    saveRobot(studio_->settings(), kept);
    const RobotChoice loaded = loadRobot(studio_->settings());
    EXPECT_EQ(loaded.urdf, urdf_);
    EXPECT_EQ(loaded.body, DrivenBody::kRightArm);
    EXPECT_FALSE(loaded.follows_posture);
    EXPECT_NEAR(loaded.speed, 0.7, 1e-12);
    studio_->settings().setValue("robot/speed", 7);
    EXPECT_NEAR(loadRobot(studio_->settings()).speed, 0.4, 1e-12) << "no such speed";
}

TEST_F(RobotPageTest, TheRobotAndItsOutlineAreDrawn) {
    startRobot("--udp");
    drive_->setRobot(choice());
    ASSERT_TRUE(waitFor([this] { return !drive_->moments().empty(); }));
    const Scene& scene = page_->center().robot().compose();
    ASSERT_EQ(scene.bodies.size(), 2U);
    EXPECT_EQ(scene.bodies[0].style, BodyStyle::kSolid);
    EXPECT_EQ(scene.bodies[1].style, BodyStyle::kOutline);
    EXPECT_EQ(scene.bodies[0].skin.size(), scene.bodies[0].mesh->bones.size());
}

/// For people to look at, in the folder of NOCTULE_TEST_PICTURES.
TEST_F(RobotPageTest, PicturesOfThePageInBothThemes) {
    const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
    if (folder.isEmpty())
        GTEST_SKIP() << "set NOCTULE_TEST_PICTURES to a folder";
    startRobot("--udp", {"--latency-ms", "80"});
    follow();
    page_->center().play();
    ASSERT_TRUE(waitFor([this] { return drive_->moments().back().time_s > 6; }));
    page_->resize(900, 800);
    page_->leftDock()->resize(248, 800);
    page_->rightDock()->resize(295, 800);
    for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
        Theme::get().setScheme(scheme);
        QTest::qWait(700);
        QImage all(248 + 900 + 295, 800, QImage::Format_RGB32);
        QPainter painter(&all);
        painter.drawPixmap(0, 0, page_->leftDock()->grab());
        painter.drawPixmap(248, 0, page_->grab());
        painter.drawPixmap(1148, 0, page_->rightDock()->grab());
        EXPECT_TRUE(all.save(folder + (scheme == Scheme::kDark ? "/robot-dark.png" : "/robot-light.png")));
    }
    Theme::get().setScheme(Scheme::kDark);
}

TEST(RobotWordsTest, JointsReadAsWords) {
    EXPECT_EQ(jointInWords("left_shoulder_pitch_joint"), "Left shoulder pitch");
    EXPECT_EQ(jointInWords("r2/right_arm/joint3"), "R2/right arm/joint3");
}

}  // namespace
}  // namespace noctule::ui
