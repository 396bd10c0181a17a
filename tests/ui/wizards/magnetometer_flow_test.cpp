// SPDX-License-Identifier: Apache-2.0
// The wizard of the magnetometers to its end: a small suit in a bag that the virtual suit rolls.
#include <QPainter>
#include <QProcess>
#include <tuple>

#include "core/processing/outside_files.h"
#include "tests/ui/wizards/wizard_flow.h"
#include "ui/wizards/field_live.h"
#include "ui/wizards/field_sensors.h"
#include "ui/wizards/sentence_card.h"
#include "ui/wizards/wizard_words.h"

namespace noctule::ui {
namespace {

using namespace test;

class MagnetometerFlow : public WizardFlow {
protected:
    /// The first boards of the default suit; `magnetometers` of them have one.
    QString suitInBag(int boards, int magnetometers) {
        const QString path = QString::fromStdString(smallSuit(folder_, boards));
        std::ifstream in(path.toStdString());
        nlohmann::json suit = nlohmann::json::parse(in);
        for (int board = 0; board < magnetometers; ++board)
            suit["boards"][static_cast<size_t>(board)]["stream"] = "imu9";
        std::ofstream(path.toStdString()) << suit.dump();
        return path;
    }
    void connectBag(const QString& suit, const QString& rig = "bag") {
        rig_ = std::make_unique<RigProgram>(
            QStringList{"--suit", suit, "--speed", "2", "--seed", "3", "--rig", rig});
        ASSERT_TRUE(rig_->isThere());
        connectAgain();
    }
    void carryAbout() {
        operate("height 1.5");
        operate("height 1");
    }
    /// The spot, then the floor, by somebody who does what the page says.
    void lookAtTheField() {
        carryAbout();
        ASSERT_TRUE(waitLong([this] { return guide().isDone(FieldGuide::kSpot); })) << said();
        operate("height 0.15");
        ASSERT_TRUE(waitLong([this] { return guide().isDone(FieldGuide::kFloor); })) << said();
        operate("height 1");
    }
    bool turnTo(double share) {
        operate("roll 600");
        return waitLong([this, share] { return guide().leastShare() > share; });
    }
    std::string said() { return page_->wizard().field().sentence().toStdString(); }
    /// The same, on the take that the wizard has left.
    void expectBatchFinds(const QString& evidence, const Calibration& found) {
        const QString out = folder_.filePath("batch.json");
        QProcess program;
        program.start(NOCTULE_PROGRAM, {"--batch", "calibrate", "magnetometers", evidence, "--out", out});
        ASSERT_TRUE(program.waitForFinished(-1));
        ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
        const auto again = readCalibrationFile(out.toStdString());
        ASSERT_TRUE(again) << again.error().text();
        ASSERT_EQ(again->boards.size(), found.boards.size());
        for (size_t board = 0; board < found.boards.size(); ++board) {
            const auto &ours = found.boards[board].mag, &theirs = again->boards[board].mag;
            ASSERT_EQ(ours.has_value(), theirs.has_value()) << found.boards[board].id;
            if (!ours)
                continue;
            EXPECT_LT((ours->zero_counts - theirs->zero_counts).norm(), 1e-6) << found.boards[board].id;
            EXPECT_LT((ours->matrix - theirs->matrix).norm(), 1e-9) << found.boards[board].id;
        }
    }
    const FieldGuide& guide() { return *run().fieldGuide(); }
    /// Rail, page and sensors side by side, as in the window; only where pictures are asked for.
    void picture(const QString& name) {
        const QString folder = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        for (const auto& [look, scheme, scale] :
             {std::tuple("dark", Scheme::kDark, 1.0), std::tuple("light", Scheme::kLight, 1.0),
              std::tuple("dark-150", Scheme::kDark, 1.5)}) {
            Theme::get().setScheme(scheme);
            Theme::get().setScale(scale);
            const QSize size = scale > 1 ? QSize(1280, 740) : QSize(1440, 820);
            const int left = Theme::get().px(248), right = Theme::get().px(scale > 1 ? 300 : 376);
            page_->leftDock()->resize(left, size.height());
            page_->rightDock()->resize(right, size.height());
            page_->resize(size.width() - left - right, size.height());
            QTest::qWait(300);
            QImage image(size, QImage::Format_RGB32);
            image.fill(Theme::get().tokens().panel);
            QPainter painter(&image);
            painter.drawPixmap(0, 0, page_->leftDock()->grab());
            painter.drawPixmap(left, 0, page_->grab());
            painter.drawPixmap(size.width() - right, 0, page_->rightDock()->grab());
            painter.end();
            image.save(QString("%1/%2-%3.png").arg(folder, name, look));
        }
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
    }
};

TEST_F(MagnetometerFlow, WalksThrough) {
    connectBag(suitInBag(4, 4));
    ASSERT_TRUE(page_->startButton(WizardTask::kMagnetometers)->isVisible());
    picture("magnetometers-overview");
    click(page_->startButton(WizardTask::kMagnetometers));
    picture("magnetometers-needs");
    click(page_->wizard().intro().beginButton());
    ASSERT_TRUE(waitLong([this] { return guide().spot().moments > 5; })) << said();
    picture("magnetometers-spot");
    lookAtTheField();
    EXPECT_TRUE(guide().spot().isBentAtFloor()) << "a beam lies in the floor";
    ASSERT_TRUE(turnTo(0.5)) << said() << " " << guide().leastShare();
    EXPECT_FALSE(page_->wizard().field().instruction().isEmpty());
    picture("magnetometers-half");
    ASSERT_TRUE(reach(Phase::kResult)) << said() << " " << guide().leastShare();
    picture("magnetometers-result");
    EXPECT_EQ(run().result()->grade(), Grade::kGood) << whatWasFound();
    const QString evidence = run().unfinished().evidence.front().path;
    const Calibration found = run().result()->calibration;
    save();
    EXPECT_LE(clicks_, 4);
    for (const BoardCalibration& board : inForce().boards) {
        EXPECT_TRUE(board.made.contains("magnetometers")) << board.id;
        ASSERT_TRUE(board.mag) << board.id;
        // Whatever way it is turned, the field is as strong.
        EXPECT_GT(board.mag->matrix.determinant(), 0) << board.id;
    }
    picture("magnetometers-saved");
    expectBatchFinds(evidence, found);
}

TEST_F(MagnetometerFlow, UsesThoseThatAreDone) {
    connectBag(suitInBag(3, 2));
    open(WizardTask::kMagnetometers);
    EXPECT_TRUE(guide().isSkipped(2)) << "it has no magnetometer";
    carryAbout();
    ASSERT_TRUE(waitLong([this] { return guide().isDone(FieldGuide::kSpot); })) << said();
    auto* card = page_->wizard().field().findChild<SentenceCard*>();
    const int usual = card->height();
    card->setSentence({Tone::kError, "What is wrong", QString("Much is to be said. ").repeated(40)});
    const int grown = card->height();
    ASSERT_GT(grown, usual);
    click(page_->wizard().fieldSensors().withoutFloorButton());
    EXPECT_TRUE(guide().isDone(FieldGuide::kFloor));
    EXPECT_TRUE(waitLong([&] { return card->height() < grown; })) << "of a sentence of the step before";
    EXPECT_FALSE(guide().spot().floor_percent);
    operate("roll 600");
    ASSERT_TRUE(waitLong([this] { return guide().enoughBoards() > 0 || run().phase() == Phase::kResult; }));
    if (run().phase() == Phase::kGuiding)
        click(page_->wizard().fieldSensors().enoughButton());
    ASSERT_TRUE(reach(Phase::kResult)) << said();
    const QString evidence = run().unfinished().evidence.front().path;
    const Calibration found = run().result()->calibration;
    save();
    EXPECT_FALSE(inForce().boards[2].mag);
    expectBatchFinds(evidence, found);
}

TEST_F(MagnetometerFlow, WhatWasTurnedIsKeptAndGoneOnWith) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("turned"), "turned"));
    connectBag(suitInBag(2, 2));
    open(WizardTask::kMagnetometers);
    lookAtTheField();
    ASSERT_TRUE(turnTo(0.3)) << said();
    operate("roll 0");
    const size_t readings = guide().readingsOf(0).size();
    const double floor_percent = guide().spot().floor_percent.value_or(0);
    // Less than 0.3 if the zero was found better meanwhile.
    const double share = guide().leastShare();
    EXPECT_GT(share, 0);
    page_->closeWizard();
    stop();  // as if another day
    start();
    studio_->session().open(folder_.filePath("turned"));
    ASSERT_TRUE(waitLong([this] { return studio_->session().isOpen(); }));
    connectAgain();
    click(page_->startButton(WizardTask::kMagnetometers));
    EXPECT_TRUE(run().isUnfinished());
    EXPECT_EQ(run().unfinished().stepsDone(), 2);
    EXPECT_NEAR(run().unfinished().share, share, 0.001);
    picture("magnetometers-kept");
    click(page_->wizard().intro().beginButton());
    EXPECT_TRUE(guide().isDone(FieldGuide::kFloor));
    EXPECT_EQ(guide().spot().floor_percent, floor_percent);
    EXPECT_GE(guide().readingsOf(0).size(), readings);
    EXPECT_NEAR(guide().leastShare(), share, 0.05) << "at once, before anything is turned again";
    ASSERT_TRUE(turnTo(0.5)) << said();
    ASSERT_TRUE(reach(Phase::kResult)) << said() << " " << guide().leastShare();
    EXPECT_EQ(run().result()->grade(), Grade::kGood) << whatWasFound();
}

TEST_F(MagnetometerFlow, EachHindranceHasItsOwnSentence) {
    connectBag(suitInBag(2, 2));
    open(WizardTask::kMagnetometers);
    lookAtTheField();
    operate("unplug 2");
    ASSERT_TRUE(waitLong([this] { return guide().guidance().hindrance == Hindrance::kAbsent; }));
    EXPECT_NE(said().find("(sensor 2) is not heard"), std::string::npos) << said();
    EXPECT_TRUE(page_->wizard().fieldSensors().skipButton()->isVisibleTo(&page_->wizard().fieldSensors()));
    operate("plug 2");
    ASSERT_TRUE(waitLong([this] { return guide().guidance().hindrance == Hindrance::kTurnOn; })) << said();
    operate("unplug 1");
    operate("unplug 2");
    ASSERT_TRUE(waitLong([this] { return guide().guidance().hindrance == Hindrance::kNoReadings; }))
        << said();
    EXPECT_EQ(said(), "No sensor is heard");
}

TEST_F(MagnetometerFlow, IsAbsentWithoutMagnetometers) {
    connectBag(suitInBag(2, 0));
    EXPECT_FALSE(page_->startButton(WizardTask::kMagnetometers)->isVisible());
    page_->open(WizardTask::kMagnetometers);
    EXPECT_EQ(run().whyNotBegin(), "No board of this suit has a magnetometer.");
}

}  // namespace
}  // namespace noctule::ui
