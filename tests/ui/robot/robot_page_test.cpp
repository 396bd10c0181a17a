// SPDX-License-Identifier: Apache-2.0
// The page "Robot" against noctule-virtual-robot: a take leads an arm, the operator's keys let it move and
// hold, faults of the robot are said. What is waited for is a state, never a time.
#include "ui/robot/robot_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QTest>

#include "tests/devices/support/test_box.h"
#include "tests/ui/robot/robot_page_fixture.h"
#include "ui/robot/add_robot_dialog.h"
#include "ui/robot/key_card.h"
#include "ui/robot/robot_sidebar.h"
#include "ui/robot/robot_view.h"
#include "ui/robot/robot_words.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

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
