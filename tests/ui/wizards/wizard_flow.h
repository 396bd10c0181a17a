// SPDX-License-Identifier: Apache-2.0
// The page of calibrations against the separate virtual suit over TCP, with an operator who does what it
// says.
#pragma once

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

namespace noctule::ui::test {

using Phase = WizardRun::Phase;

/// Ends a wait for what never comes; a busy machine may take many times as long as a quiet one.
inline constexpr int kLong_ms = 240'000;
inline constexpr const char* kSideNames[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

inline bool waitLong(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kLong_ms);
}

/// The default suit with its first boards only.
inline std::string smallSuit(const QTemporaryDir& folder, int boards) {
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
        QSettings().setValue("folders/suits", folder_.filePath("suits"));
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

    void connectRig(const QStringList& options, const QString& speed = "2") {
        rig_ = std::make_unique<RigProgram>(QStringList{"--suit",
                                                        QString::fromStdString(smallSuit(folder_, boards_)),
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
    /// Of the same suit as the rig's.
    void simulate(const QStringList& options) {
        QProcess program;
        program.start(NOCTULE_PROGRAM,
                      QStringList{"--batch", "simulate", "--suit",
                                  QString::fromStdString(smallSuit(folder_, boards_)), "--seed", "3",
                                  "--level", "readings", "--out", folder_.filePath("simulated.noctule")} +
                          options);
        ASSERT_TRUE(program.waitForFinished(-1));
        ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    }
    /// Points of the rig's jig.
    QString digitizedJig() {
        const QString points = folder_.filePath("jig.csv");
        simulate({"--rig", "jig", "--digitizer-out", points});
        return points;
    }
    /// Sensors and sources have been calibrated before.
    void useLaboratorysCalibration(const QStringList& options) {
        const QString folder = folder_.filePath("calibrated");
        ASSERT_TRUE(studio_->session().create(folder, "calibrated"));
        simulate(options + QStringList{"--calibration-out", folder + "/calibration/laboratory.json"});
        studio_->calibrations().use("laboratory.json", "Use it");
        ASSERT_TRUE(studio_->calibrations().inForce());
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
    /// `pause_ms`: how long the operator takes to turn the boards before each.
    void spinEachSide(int pause_ms = 0) {
        for (int side = 0; side < 6; ++side) {
            QTest::qWait(pause_ms);
            operate(QByteArray("spin ") + kSideNames[side] + " 45");
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
    int boards_ = 4;  ///< of the small suit
};

}  // namespace noctule::ui::test
