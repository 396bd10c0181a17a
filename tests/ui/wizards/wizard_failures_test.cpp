// SPDX-License-Identifier: Apache-2.0
// Wizards through everything that can go wrong. A small suit at several times its speed.
#include "tests/ui/wizards/wizard_flow.h"
#include "ui/wizards/task_card.h"
#include "ui/wizards/wizard_words.h"

namespace noctule::ui {
namespace {

using namespace test;

class WizardFailures : public WizardFlow {};

TEST_F(WizardFailures, SpunOneWayOnlyIsSaidAndNotUsable) {
    connectRig({"--rig", "turntable"});
    open(WizardTask::kGyroscopes);
    operate("spin +z 45");
    ASSERT_TRUE(waitLong([this] { return run().guide()->isDone(4); })) << heard();
    EXPECT_TRUE(waitLong([this] { return heard().ends_with("is done"); })) << heard();
    click(page_->wizard().boards().enoughButton());
    ASSERT_TRUE(reach(Phase::kResult));
    EXPECT_EQ(run().result()->grade(), Grade::kNotUsable);
    EXPECT_EQ(page_->wizard().resultSide().saveButton()->text(), "Save and use it anyway");
    EXPECT_EQ(page_->wizard().resultSide().saveButton()->kind(), ButtonKind::kOutlined);
    EXPECT_EQ(page_->wizard().resultSide().repeatButton()->kind(), ButtonKind::kPrimary) << "is advised";
}

TEST_F(WizardFailures, DistancesInTheWrongUnitAreSaidInWords) {
    QFile points(digitizedJig());
    ASSERT_TRUE(points.open(QFile::ReadOnly));
    QByteArray table = points.readAll();
    ASSERT_TRUE(table.contains("x_m,y_m,z_m")) << table.left(80).toStdString();
    QFile wrong(folder_.filePath("wrong.csv"));
    ASSERT_TRUE(wrong.open(QFile::WriteOnly));
    wrong.write(table.replace("x_m,y_m,z_m", "x_mm,y_mm,z_mm"));
    wrong.close();
    connectRig({"--rig", "jig"});
    click(page_->startButton(WizardTask::kSources));
    page_->wizard().intro().useDistances(wrong.fileName());
    click(page_->wizard().intro().beginButton());
    ASSERT_TRUE(waitLong([this] { return heard() == "The file’s distances are 0.001 times those heard"; }))
        << heard();
    EXPECT_EQ(stepsDone(), 0);
}

TEST_F(WizardFailures, ABoardUnpluggedInTheMiddleIsNamedAndCanBeSkipped) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide(0, 2);
    operate("unplug 2");
    operate("side -y");
    ASSERT_TRUE(waitLong([this] { return heard().starts_with("Board 2, "); })) << heard();
    EXPECT_TRUE(QString::fromStdString(heard()).endsWith("is silent")) << heard();
    EXPECT_EQ(stepsDone(), 3);
    click(page_->wizard().boards().skipButton());
    turnToEachSide(3, 5);
    ASSERT_TRUE(reach(Phase::kResult));
    const std::string skipped = run().suit().boards[1].id;
    EXPECT_FALSE(run().result()->calibration.findBoard(skipped)->made.contains("accelerometers"));
    EXPECT_TRUE(
        run().result()->calibration.findBoard(run().suit().boards[0].id)->made.contains("accelerometers"));
}

TEST_F(WizardFailures, MovedDuringASideTheCountBeginsAgain) {
    connectRig({"--rig", "level"}, "2");
    open(WizardTask::kAccelerometers);
    ASSERT_TRUE(waitLong([this] { return run().heldShare() > 0.3; }));
    operate("side +x");
    ASSERT_TRUE(waitLong([this] { return run().heldShare() == 0 && run().phase() == Phase::kGuiding; }));
    EXPECT_EQ(stepsDone(), 0) << "a side that was moved is not taken";
    ASSERT_TRUE(waitLong([this] { return stepsDone() == 1; }));
    EXPECT_TRUE(run().guide()->isDone(0));
}

TEST_F(WizardFailures, ABoxThatIsGoneInTheMiddleOfAStepIsSaidAndNothingStaysGreen) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    ASSERT_TRUE(waitLong([this] { return run().heldShare() > 0.2; })) << heard();
    rig_->kill();
    ASSERT_TRUE(waitLong([this] { return heard() == "The suit has gone"; })) << heard();
    EXPECT_EQ(run().heldShare(), 0);
    for (const LiveMeasure& measure : measuresOf(run()))
        EXPECT_FALSE(measure.is_right) << measure.name.toStdString();
    EXPECT_EQ(stepsDone(), 0);
}

TEST_F(WizardFailures, WhatWasTakenSurvivesTheStudio) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide(0, 2);
    const QString session = QString::fromStdString(studio_->session().session().folder.string());
    stop();  // nothing is asked, nothing is saved: as if it had been killed
    start();
    studio_->session().open(session);
    ASSERT_TRUE(waitLong([this] { return studio_->session().isOpen(); }));
    connectAgain();
    const QString overview = page_->card(WizardTask::kAccelerometers).state();
    EXPECT_TRUE(overview.startsWith("Not calibrated yet. 3 step")) << overview.toStdString();
    EXPECT_EQ(page_->card(WizardTask::kGyroscopes).state(), "Not calibrated yet");
    EXPECT_EQ(page_->startButton(WizardTask::kAccelerometers)->text(), "Prepare");
    click(page_->startButton(WizardTask::kAccelerometers));
    EXPECT_EQ(page_->wizard().intro().beginButton()->text(), "Go on");
    click(page_->wizard().intro().beginButton());
    EXPECT_EQ(stepsDone(), 3);
    turnToEachSide(3, 5);
    ASSERT_TRUE(reach(Phase::kResult));
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
}

TEST_F(WizardFailures, ABoardThatIsSkippedKeepsItsValuesThoughItIsHeard) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    run().skip(2, true);
    turnToEachSide();
    ASSERT_TRUE(reach(Phase::kResult));
    const auto& boards = run().suit().boards;
    const Calibration& found = run().result()->calibration;
    EXPECT_FALSE(found.findBoard(boards[2].id)->made.contains("accelerometers"));
    EXPECT_EQ(found.findBoard(boards[2].id)->accel.zero_counts, Vector3d(2048, 2048, 2048));
    EXPECT_TRUE(found.findBoard(boards[0].id)->made.contains("accelerometers"));
}

TEST_F(WizardFailures, NothingIsTakenWhileAnotherPageIsShown) {
    connectRig({"--rig", "rest"});
    open(WizardTask::kRestPose);
    page_->leave();
    QTest::qWait(3000);
    EXPECT_EQ(run().phase(), Phase::kGuiding);
    page_->enter();
    EXPECT_TRUE(reach(Phase::kResult)) << heard();
}

TEST_F(WizardFailures, BeginningAnewWithoutASuitKeepsWhatWasTaken) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide(0, 0);
    page_->closeWizard();
    studio_->suit().disconnectSuit();
    ASSERT_TRUE(waitLong([this] { return studio_->suit().phase() == LiveSuit::Phase::kNone; }));
    click(page_->startButton(WizardTask::kAccelerometers));
    ASSERT_TRUE(run().isUnfinished());
    EXPECT_FALSE(page_->wizard().intro().anewButton()->isEnabled());
    run().beginAnew();
    EXPECT_TRUE(run().isUnfinished());
}

TEST_F(WizardFailures, AResultThatWasLeftComesBack) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide();
    ASSERT_TRUE(reach(Phase::kResult));
    page_->closeWizard();
    click(page_->startButton(WizardTask::kAccelerometers));
    click(page_->wizard().intro().beginButton());
    EXPECT_TRUE(reach(Phase::kResult)) << heard();
}

TEST_F(WizardFailures, EveryWizardOpensWithoutASuitAndSaysWhatIsMissing) {
    for (const WizardTask task : kWizardTasks) {
        page_->open(task);
        EXPECT_FALSE(page_->wizard().intro().beginButton()->isEnabled()) << keyOf(task).toStdString();
        EXPECT_FALSE(run().whyNotBegin().isEmpty());
        run().begin();
        EXPECT_EQ(run().phase(), Phase::kIntro);
    }
}

TEST_F(WizardFailures, ADamagedRecordOfAnUnfinishedCalibrationDoesNoHarm) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("one"), "one"));
    for (const char* text : {"", "{", "[]", R"({"evidence": 3})", R"({"started_utc": 1, "evidence": []})",
                             R"({"evidence": [{"file": "../session.json", "step": -4, "boards": ["x"]}]})"}) {
        std::ofstream(folder_.filePath("one/calibration/gyroscopes.NB-1.unfinished.json").toStdString())
            << text;
        page_->open(WizardTask::kGyroscopes);
        EXPECT_FALSE(run().isUnfinished()) << text;
    }
}

TEST_F(WizardFailures, ASideIsRepeatedAndItsTakeLeaves) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide(0, 0);
    const QDir evidence(QString::fromStdString(studio_->session().session().evidenceFolder().string()));
    EXPECT_EQ(evidence.entryList({"*.noctule"}).size(), 1);
    page_->wizard().boards().repeatStep();
    EXPECT_EQ(stepsDone(), 0);
    EXPECT_EQ(evidence.entryList({"*.noctule"}).size(), 0);
    EXPECT_TRUE(waitLong([this] { return stepsDone() == 1; })) << heard();
}

/// Run by the test below, which kills it: a studio that takes the sides as they are shown.
TEST_F(WizardFailures, AStudioToBeKilled) {
    const QString box = qEnvironmentVariable("NOCTULE_WIZARD_BOX");
    if (box.isEmpty())
        GTEST_SKIP() << "a part of KilledInTheMiddleItGoesOnWithWhatWasTaken";
    ASSERT_TRUE(studio_->session().create(qEnvironmentVariable("NOCTULE_WIZARD_SESSION"), "killed"));
    studio_->suit().connectTo(box);
    ASSERT_TRUE(waitLong([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    open(WizardTask::kAccelerometers);
    waitLong([this, said = 0]() mutable {
        if (stepsDone() > said)
            std::printf("sides: %d\n", said = stepsDone());
        std::fflush(stdout);
        return false;
    });
}

TEST_F(WizardFailures, KilledInTheMiddleItGoesOnWithWhatWasTaken) {
    connectRig({"--rig", "level"});
    studio_->suit().disconnectSuit();
    ASSERT_TRUE(waitLong([this] { return studio_->suit().phase() == LiveSuit::Phase::kNone; }));
    const QString session = folder_.filePath("killed");
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("NOCTULE_WIZARD_BOX", rig_->address());
    environment.insert("NOCTULE_WIZARD_SESSION", session);
    for (const char* part : {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX"})
        environment.remove(part);  // the one test is all that it runs
    victim.setProcessEnvironment(environment);
    victim.start(QCoreApplication::applicationFilePath(),
                 {"--gtest_filter=WizardFailures.AStudioToBeKilled"});
    QByteArray heard;
    for (int side = 0; side < 3; ++side) {
        operate(QByteArray("side ") + kSideNames[side]);
        ASSERT_TRUE(waitLong([&] {
            heard += victim.readAllStandardOutput();
            return heard.contains("sides: " + QByteArray::number(side + 1));
        })) << heard.toStdString();
    }
    victim.kill();
    ASSERT_TRUE(victim.waitForFinished());
    EXPECT_EQ(victim.exitStatus(), QProcess::CrashExit);
    studio_->session().open(session);
    ASSERT_TRUE(waitLong([this] { return studio_->session().isOpen(); }));
    connectAgain();
    open(WizardTask::kAccelerometers);
    EXPECT_EQ(stepsDone(), 3);
    turnToEachSide(3, 5);
    ASSERT_TRUE(reach(Phase::kResult));
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
}

}  // namespace
}  // namespace noctule::ui
