// SPDX-License-Identifier: Apache-2.0
// Each wizard to its end against the separate virtual suit over TCP, with an operator who does what the page
// says, and through its failures. A small suit at several times its speed.
#include <gtest/gtest.h>

#include <QDir>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "core/guide/guide.h"
#include "tests/support/files.h"
#include "tests/ui/wizards/rig_program.h"
#include "ui/style/theme.h"
#include "ui/widgets/button.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/result_side.h"
#include "ui/wizards/wizard_boards.h"
#include "ui/wizards/wizard_intro.h"
#include "ui/wizards/wizard_live.h"
#include "ui/wizards/wizard_page.h"
#include "ui/wizards/wizard_rail.h"

namespace noctule::ui {
namespace {

using test::RigProgram;
using Phase = WizardRun::Phase;

constexpr int kLong_ms = 25'000;
constexpr const char* kSideNames[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

bool waitLong(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kLong_ms);
}

/// The default suit with its first boards only.
std::string smallSuit(const QTemporaryDir& folder, int boards) {
    std::ifstream file(NOCTULE_SOURCE_DIR "/resources/suits/default.json");
    nlohmann::json suit = nlohmann::json::parse(file);
    auto& all = suit["boards"];
    all.erase(all.begin() + boards, all.end());
    const std::string path = folder.filePath("suit.json").toStdString();
    std::ofstream(path) << suit.dump();
    return path;
}

class WizardFlow : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        QSettings().clear();
        start();
    }
    void start() {
        StudioParts parts;
        parts.software = "noctule test";
        parts.utc_now = [] { return std::string("2026-03-01T10:00:00Z"); };
        studio_ = std::make_unique<Studio>(parts);
        studio_->settings().setValue("folders/sessions", folder_.filePath("sessions"));
        studio_->settings().setValue("calibrate/tones", false);
        page_ = std::make_unique<CalibratePage>(*studio_);
        page_->resize(1000, 800);
        page_->show();
    }
    void stop() {
        page_.reset();
        studio_.reset();
    }
    void TearDown() override { stop(); }

    void connectRig(const QStringList& options, const QString& speed = "8") {
        rig_ =
            std::make_unique<RigProgram>(QStringList{"--suit", QString::fromStdString(smallSuit(folder_, 4)),
                                                     "--speed", speed, "--seed", "3"} +
                                         options);
        ASSERT_TRUE(rig_->isThere());
        connectAgain();
    }
    void connectAgain() {
        studio_->suit().connectTo(rig_->address());
        ASSERT_TRUE(waitLong([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    }
    void click(QAbstractButton* button) {
        ASSERT_TRUE(button->isEnabled()) << button->text().toStdString();
        ++clicks_;
        button->click();
    }
    WizardRun& run() { return *page_->wizard().run(); }
    void open(WizardTask task) {
        click(page_->startButton(task));
        click(page_->wizard().intro().beginButton());
        ASSERT_EQ(run().phase(), Phase::kGuiding);
    }
    int stepsDone() {
        int done = 0;
        for (int step = 0; step < run().stepCount(); ++step)
            done += run().guide()->isDone(step);
        return done;
    }
    bool reach(Phase phase) {
        return waitLong([&] { return run().phase() == phase; });
    }
    std::string heard() { return page_->wizard().live().sentence().toStdString(); }
    std::string whatWasFound() {
        std::string text;
        for (const Finding& finding : run().result()->document.findings)
            text += finding.what + "\n";
        return text;
    }
    /// What the operator does when the page asks for a side.
    void operate(const QByteArray& command) { ASSERT_EQ(rig_->tell(command), "ok"); }
    void turnToEachSide(int first = 0, int last = 5) {
        for (int side = first; side <= last; ++side) {
            operate(QByteArray("side ") + kSideNames[side]);
            ASSERT_TRUE(waitLong([&] {
                return run().phase() >= Phase::kSolving || run().guide()->isDone(side);
            })) << kSideNames[side]
                << ": " << heard();
        }
    }
    void save() {
        ASSERT_TRUE(run().result());
        click(page_->wizard().resultSide().saveButton());
        EXPECT_TRUE(run().isSaved());
    }
    const Calibration& inForce() {
        in_force_ = studio_->calibrations().inForce().value();
        return in_force_;
    }

    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<CalibratePage> page_;
    std::unique_ptr<RigProgram> rig_;
    Calibration in_force_;
    int clicks_ = 0;
};

TEST_F(WizardFlow, Accelerometers) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide();
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    save();
    EXPECT_LE(clicks_, 4);
    for (const BoardCalibration& board : inForce().boards)
        EXPECT_TRUE(board.made.contains("accelerometers")) << board.id;
    // Undone as a whole.
    studio_->session().undoStack().undo();
    EXPECT_EQ(studio_->calibrations().fileInForce(), "");
    studio_->session().undoStack().redo();
    EXPECT_EQ(studio_->calibrations().fileInForce(),
              "accelerometers-" + QDate::currentDate().toString(Qt::ISODate) + ".json");
    EXPECT_TRUE(
        QFile::exists(QString::fromStdString(studio_->session().session().calibrationFolder().string()) +
                      "/" + studio_->calibrations().fileInForce().replace(".json", ".html")));
}

TEST_F(WizardFlow, Gyroscopes) {
    connectRig({"--rig", "turntable"});
    open(WizardTask::kGyroscopes);
    EXPECT_TRUE(waitLong([this] { return heard() == "Start the table"; })) << heard();
    for (int side = 0; side < 6; ++side) {
        operate(QByteArray("spin ") + kSideNames[side] + " 45");
        ASSERT_TRUE(waitLong([&] { return run().phase() >= Phase::kSolving || run().guide()->isDone(side); }))
            << kSideNames[side] << ": " << heard();
    }
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    save();
    EXPECT_LE(clicks_, 4);
}

TEST_F(WizardFlow, SpunOneWayOnlyIsSaidAndNotUsable) {
    connectRig({"--rig", "turntable"});
    open(WizardTask::kGyroscopes);
    operate("spin +z 45");
    ASSERT_TRUE(waitLong([this] { return run().guide()->isDone(4); })) << heard();
    EXPECT_TRUE(waitLong([this] { return heard().ends_with("is done"); })) << heard();
    click(page_->wizard().boards().enoughButton());
    ASSERT_TRUE(reach(Phase::kResult));
    EXPECT_EQ(run().result()->grade(), Grade::kNotUsable);
    EXPECT_EQ(page_->wizard().resultSide().saveButton()->text(), "Save and use it anyway");
}

TEST_F(WizardFlow, RestPose) {
    connectRig({"--rig", "rest"});
    open(WizardTask::kRestPose);
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(run().result()->grade(), Grade::kUnknown);
    save();
    page_->closeWizard();
    clicks_ = 0;
    open(WizardTask::kCheck);
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_FALSE(page_->wizard().resultSide().saveButton()->isVisible()) << "a check changes nothing";
    EXPECT_EQ(clicks_, 2);
}

TEST_F(WizardFlow, Sources) {
    const QString points = folder_.filePath("jig.csv");
    {
        QProcess simulate;
        simulate.start(NOCTULE_PROGRAM,
                       {"--batch", "simulate", "--rig", "jig", "--suit",
                        QString::fromStdString(smallSuit(folder_, 4)), "--seed", "3", "--level", "readings",
                        "--out", folder_.filePath("jig.noctule"), "--digitizer-out", points});
        ASSERT_TRUE(simulate.waitForFinished(60'000));
        ASSERT_EQ(simulate.exitCode(), 0) << simulate.readAllStandardError().toStdString();
    }
    connectRig({"--rig", "jig"});
    click(page_->startButton(WizardTask::kSources));
    EXPECT_FALSE(page_->wizard().intro().beginButton()->isEnabled()) << "distances are missing";
    ++clicks_;  // "Choose the distances"
    page_->wizard().intro().useDistances(folder_.filePath("nothing.csv"));
    EXPECT_EQ(page_->wizard().intro().problem(), "The distances could not be read");
    page_->wizard().intro().useDistances(points);
    EXPECT_EQ(page_->wizard().intro().problem(), "");
    click(page_->wizard().intro().beginButton());
    for (int placement = 0; placement < run().stepCount(); ++placement) {
        operate(QByteArray("placement ") + QByteArray::number(placement + 1));
        ASSERT_TRUE(waitLong([&] {
            return run().phase() >= Phase::kSolving || run().guide()->isDone(placement);
        })) << placement + 1
            << ": " << heard();
    }
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    save();
    EXPECT_LE(clicks_, 4);
}

TEST_F(WizardFlow, ABoardUnpluggedInTheMiddleIsNamedAndCanBeSkipped) {
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

TEST_F(WizardFlow, MovedDuringASideTheCountBeginsAgain) {
    connectRig({"--rig", "level"}, "2");
    open(WizardTask::kAccelerometers);
    ASSERT_TRUE(waitLong([this] { return run().heldShare() > 0.3; }));
    operate("side +x");
    ASSERT_TRUE(waitLong([this] { return run().heldShare() == 0 && run().phase() == Phase::kGuiding; }));
    EXPECT_EQ(stepsDone(), 0) << "a side that was moved is not taken";
    ASSERT_TRUE(waitLong([this] { return stepsDone() == 1; }));
    EXPECT_TRUE(run().guide()->isDone(0));
}

TEST_F(WizardFlow, WhatWasTakenSurvivesTheStudio) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide(0, 2);
    const QString session = QString::fromStdString(studio_->session().session().folder.string());
    stop();  // nothing is asked, nothing is saved: as if it had been killed
    start();
    studio_->session().open(session);
    ASSERT_TRUE(waitLong([this] { return studio_->session().isOpen(); }));
    connectAgain();
    click(page_->startButton(WizardTask::kAccelerometers));
    EXPECT_EQ(page_->wizard().intro().beginButton()->text(), "Go on");
    click(page_->wizard().intro().beginButton());
    EXPECT_EQ(stepsDone(), 3);
    turnToEachSide(3, 5);
    ASSERT_TRUE(reach(Phase::kResult));
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
}

TEST_F(WizardFlow, ABoardThatIsSkippedKeepsItsValuesThoughItIsHeard) {
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

TEST_F(WizardFlow, NothingIsTakenWhileAnotherPageIsShown) {
    connectRig({"--rig", "rest"});
    open(WizardTask::kRestPose);
    page_->leave();
    QTest::qWait(3000);
    EXPECT_EQ(run().phase(), Phase::kGuiding);
    page_->enter();
    EXPECT_TRUE(reach(Phase::kResult)) << heard();
}

TEST_F(WizardFlow, BeginningAnewWithoutASuitKeepsWhatWasTaken) {
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

TEST_F(WizardFlow, AResultThatWasLeftComesBack) {
    connectRig({"--rig", "level"});
    open(WizardTask::kAccelerometers);
    turnToEachSide();
    ASSERT_TRUE(reach(Phase::kResult));
    page_->closeWizard();
    click(page_->startButton(WizardTask::kAccelerometers));
    click(page_->wizard().intro().beginButton());
    EXPECT_TRUE(reach(Phase::kResult)) << heard();
}

TEST_F(WizardFlow, EveryWizardOpensWithoutASuitAndSaysWhatIsMissing) {
    for (const WizardTask task : kWizardTasks) {
        page_->open(task);
        EXPECT_FALSE(page_->wizard().intro().beginButton()->isEnabled()) << keyOf(task).toStdString();
        EXPECT_FALSE(run().whyNotBegin().isEmpty());
        run().begin();
        EXPECT_EQ(run().phase(), Phase::kIntro);
    }
}

TEST_F(WizardFlow, ADamagedRecordOfAnUnfinishedCalibrationDoesNoHarm) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("one"), "one"));
    for (const char* text : {"", "{", "[]", R"({"evidence": 3})", R"({"started_utc": 1, "evidence": []})",
                             R"({"evidence": [{"file": "../session.json", "step": -4, "boards": ["x"]}]})"}) {
        std::ofstream(folder_.filePath("one/calibration/gyroscopes.unfinished.json").toStdString()) << text;
        page_->open(WizardTask::kGyroscopes);
        EXPECT_FALSE(run().isUnfinished()) << text;
    }
}

TEST_F(WizardFlow, ASideIsRepeatedAndItsTakeLeaves) {
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

}  // namespace
}  // namespace noctule::ui
