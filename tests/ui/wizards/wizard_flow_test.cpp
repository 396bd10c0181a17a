// SPDX-License-Identifier: Apache-2.0
// Each wizard to its end. A small suit at several times its speed.
#include "tests/ui/wizards/wizard_flow.h"

#include <QElapsedTimer>

#include "core/formats/bvh.h"
#include "tests/support/guided_motion.h"
#include "ui/wizards/rig_drawing.h"
#include "ui/wizards/task_card.h"

namespace noctule::ui {
namespace {

using namespace test;

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
    // The suit keeps what was found of it.
    ASSERT_TRUE(studio_->session().create(folder_.filePath("sessions/another"), "another"));
    ASSERT_TRUE(waitLong([this] { return studio_->calibrations().remembered().has_value(); }));
    ASSERT_FALSE(inForce().boards.empty());
    EXPECT_TRUE(in_force_.boards[0].made.contains("accelerometers"));
}

TEST_F(WizardFlow, Gyroscopes) {
    connectRig({"--rig", "turntable"});
    open(WizardTask::kGyroscopes);
    EXPECT_TRUE(waitLong([this] { return heard() == "Start the table"; })) << heard();
    spinEachSide();
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    save();
    EXPECT_LE(clicks_, 4);
}

TEST_F(WizardFlow, RestPose) {
    connectRig({"--rig", "rest"});
    page_->open(WizardTask::kRestPose);
    EXPECT_EQ(page_->wizard().intro().prerequisite(), "Better after the gyroscopes");
    page_->closeWizard();
    open(WizardTask::kRestPose);
    const auto hand_m = [](const BodyFigure& figure) {
        Board hand;
        hand.segment = "LeftHand";
        return figure.board(hand);
    };
    const BodyFigure rest(studio_->suit().actor(), studio_->body(), BodyFigure::Stance::kRest);
    for (QWidget* page :
         {static_cast<QWidget*>(&page_->wizard().intro()), static_cast<QWidget*>(&page_->wizard().live())}) {
        const BodyFigure* shown = page->findChild<RigDrawing*>()->figure();
        ASSERT_TRUE(shown);
        EXPECT_NEAR(hand_m(*shown).x(), hand_m(rest).x(), 1e-6) << "as the solver takes for granted";
    }
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(run().result()->grade(), Grade::kUnknown);
    EXPECT_NE(whatWasFound().find("Made before the gyroscopes were calibrated"), std::string::npos)
        << "as the card said";
    EXPECT_EQ(whatWasFound().find("marks no rest pose"), std::string::npos) << whatWasFound();
    EXPECT_EQ(whatWasFound().find(", moved at "), std::string::npos) << whatWasFound();
    save();
    page_->closeWizard();
    EXPECT_FALSE(page_->startButton(WizardTask::kCheck)->isEnabled()) << "gyroscopes are not calibrated";
    useLaboratorysCalibration({"--rig", "rest"});
    EXPECT_EQ(page_->card(WizardTask::kGyroscopes).state(), "In use; where it comes from is not stated");
    page_->open(WizardTask::kRestPose);
    EXPECT_EQ(page_->wizard().intro().prerequisite(), "");
    page_->closeWizard();
    clicks_ = 0;
    open(WizardTask::kCheck);
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_FALSE(page_->wizard().resultSide().saveButton()->isVisible()) << "a check changes nothing";
    EXPECT_EQ(clicks_, 2);
    ASSERT_TRUE(studio_->checked()) << "step Record says when";

    // From Record it begins by itself, and leads back there.
    page_->closeWizard();
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    page_->checkBeforeTake();
    EXPECT_EQ(run().phase(), Phase::kGuiding);
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_EQ(static_cast<WizardRail*>(page_->wizard().rail())->leaveButton()->text(), "Back to Record");
    page_->closeWizard();
    ASSERT_EQ(steps.size(), 1);
    EXPECT_EQ(steps.at(0).at(0).value<Step>(), Step::kRecord);
}

TEST_F(WizardFlow, TheCheckNamesExchangedBoards) {
    boards_ = 8;
    connectRig({"--rig", "rest"}, "1");
    useLaboratorysCalibration({"--rig", "rest"});
    ASSERT_EQ(rig_->tell("swap l_forearm l_hand"), "ok");
    open(WizardTask::kCheck);
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    EXPECT_NE(whatWasFound().find("Boards 7 (left forearm) and 8 (left hand) seem to be exchanged"),
              std::string::npos)
        << whatWasFound();
}

TEST_F(WizardFlow, Movement) {
    const QString motion = folder_.filePath("guided.bvh");
    ASSERT_TRUE(
        writeBvh(motion.toStdString(), noctule::test::GuidedMotion::clip({8.5, 3.5, 0.035}), {}, true));
    connectRig({"--motion", motion, "--loop"});
    useLaboratorysCalibration({"--motion", motion, "--duration", "4"});
    open(WizardTask::kMovement);
    for (int step = 0; step < kExerciseCount; ++step)
        ASSERT_TRUE(waitLong([&] { return run().phase() >= Phase::kSolving || run().guide()->isDone(step); }))
            << step << ": " << heard();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().phase() == Phase::kResult; }, 120'000))
        << static_cast<int>(run().phase()) << " " << run().trouble().toStdString();
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    EXPECT_TRUE(run().result()->document.summary.ends_with("and 6 rest poses"))
        << run().result()->document.summary;
    const auto thigh = [this] { return studio_->session().session().performers.front().measures.thigh_m; };
    const double before_m = thigh();
    save();
    EXPECT_LE(clicks_, 4);
    EXPECT_NE(thigh(), before_m) << "bones become the performer's";
    studio_->session().undoStack().undo();
    EXPECT_EQ(thigh(), before_m);
    EXPECT_EQ(studio_->calibrations().fileInForce(), "laboratory.json");
}

TEST_F(WizardFlow, Sources) {
    const QString points = digitizedJig();
    connectRig({"--rig", "jig"});
    click(page_->startButton(WizardTask::kSources));
    EXPECT_FALSE(page_->wizard().intro().beginButton()->isEnabled()) << "distances are missing";
    ++clicks_;  // "Choose the distances"
    page_->wizard().intro().useDistances(folder_.filePath("nothing.csv"));
    EXPECT_EQ(page_->wizard().intro().problem(), "The distances could not be read");
    page_->wizard().intro().useDistances(points);
    EXPECT_EQ(page_->wizard().intro().problem(), "");
    run().solveTakes({folder_.filePath("nothing.noctule")});
    ASSERT_TRUE(waitLong([this] { return !run().trouble().isEmpty(); }));
    EXPECT_EQ(page_->wizard().intro().problem(), "The takes could not be used");
    page_->wizard().intro().useDistances(points);
    EXPECT_EQ(page_->wizard().intro().problem(), "") << "tried anew with other distances";
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

/// A whole suit, an operator of flesh: packaging/acceptance/calibration.py.
TEST_F(WizardFlow, EighteenBoardsOnOnePlateAtAnOperatorsPace) {
    if (!qEnvironmentVariableIsSet("NOCTULE_WIZARD_PACE"))
        GTEST_SKIP() << "minutes; set NOCTULE_WIZARD_PACE";
    constexpr int kReads_ms = 5000, kTurns_ms = 10'000;
    rig_ = std::make_unique<RigProgram>(QStringList{"--rig", "level", "--seed", "3"});
    ASSERT_TRUE(rig_->isThere());
    connectAgain();
    QElapsedTimer clock;
    clock.start();
    open(WizardTask::kAccelerometers);
    QTest::qWait(kReads_ms);
    for (int side = 0; side < 6; ++side) {
        QTest::qWait(kTurns_ms);
        turnToEachSide(side, side);
    }
    ASSERT_TRUE(reach(Phase::kResult));
    save();
    std::printf("18 boards on one plate: %.0f s, %d clicks\n", static_cast<double>(clock.elapsed()) / 1e3,
                clicks_);
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    EXPECT_LT(clock.elapsed(), 360'000);
    EXPECT_LE(clicks_, 4);
}

TEST_F(WizardFlow, EighteenBoardsOnATurntableAtAnOperatorsPace) {
    if (!qEnvironmentVariableIsSet("NOCTULE_WIZARD_PACE"))
        GTEST_SKIP() << "minutes; set NOCTULE_WIZARD_PACE";
    constexpr int kReads_ms = 5000, kTurns_ms = 10'000;
    rig_ = std::make_unique<RigProgram>(QStringList{"--rig", "turntable", "--seed", "3"});
    ASSERT_TRUE(rig_->isThere());
    connectAgain();
    QElapsedTimer clock;
    clock.start();
    open(WizardTask::kGyroscopes);
    QTest::qWait(kReads_ms);
    spinEachSide(kTurns_ms);
    ASSERT_TRUE(reach(Phase::kResult)) << heard();
    ASSERT_TRUE(run().result());
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    save();
    std::printf("18 boards on one turntable: %.0f s, %d clicks, %s\n",
                static_cast<double>(clock.elapsed()) / 1e3, clicks_, gradeWord(run().result()->grade()));
    EXPECT_LE(clicks_, 4);
    ASSERT_EQ(inForce().boards.size(), 18u);
    for (const BoardCalibration& board : in_force_.boards)
        EXPECT_TRUE(board.made.contains("gyroscopes")) << board.id;
}

}  // namespace
}  // namespace noctule::ui
