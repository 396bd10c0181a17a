// SPDX-License-Identifier: Apache-2.0
// Step Calibrate with two suits, each a box that plays the tiny take over TCP.
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/views/connect/suit_switch.h"
#include "ui/widgets/button.h"
#include "ui/widgets/tool_button.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/unfinished_calibration.h"
#include "ui/wizards/wizard_page.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class CalibrateTwoSuits : public test::StudioWindow {
protected:
    void SetUp() override {
        StudioWindow::SetUp();
        ASSERT_TRUE(studio_->session().create(home() + "-duo", "duo"));
        for (TestBox* box : {&ann_, &bob_}) {
            studio_->suits().add(QString::fromStdString(box->address()));
            ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
        }
        window_->goTo(Step::kCalibrate);
    }
    CalibratePage& page() { return dynamic_cast<CalibratePage&>(window_->page(Step::kCalibrate)); }
    QToolButton& performer(size_t index) { return *page().suits().buttons().at(index); }

    TestBox ann_{{.loops = true, .serial = "NB-000001", .drive_hz = 40000}},
        bob_{{.loops = true, .serial = "NB-000002", .drive_hz = 48000}};
};

TEST_F(CalibrateTwoSuits, ItSaysWhoseCalibrationIsShownAndShowsTheOthers) {
    ASSERT_EQ(page().suits().buttons().size(), 2u);
    EXPECT_TRUE(page().suits().isVisible());
    EXPECT_EQ(performer(1).text(), "Performer 2");
    EXPECT_FALSE(performer(1).icon().isNull()) << "letter and colour";
    EXPECT_TRUE(performer(1).isChecked()) << "the one that came last is looked at";
    performer(0).click();
    EXPECT_EQ(&studio_->suits().current(), studio_->suits().connected()[0]);
    EXPECT_TRUE(performer(0).isChecked());
    page().openRoom();
    EXPECT_FALSE(page().suits().isVisible()) << "the room is of a take";
    studio_->suits().connected()[1]->suit.disconnectSuit();
    EXPECT_TRUE(page().suits().isHidden()) << "there is one only";
}

TEST_F(CalibrateTwoSuits, WhatAWizardHasTakenIsNotLostByLookingAtTheOther) {
    page().open(WizardTask::kAccelerometers);
    EXPECT_TRUE(page().suits().isVisible()) << "in a wizard, too";
    page().wizard().run()->begin();
    ASSERT_EQ(page().wizard().run()->phase(), WizardRun::Phase::kGuiding);
    QSignalSpy said(studio_.get(), &Studio::said);
    performer(0).click();
    EXPECT_EQ(&studio_->suits().current(), studio_->suits().connected()[1]);
    EXPECT_EQ(page().wizard().run()->phase(), WizardRun::Phase::kGuiding);
    ASSERT_EQ(said.count(), 1);
    EXPECT_TRUE(said[0][0].toString().contains("Finish or leave this calibration"));
    studio_->suits().setCurrent(*studio_->suits().connected()[0]);
    studio_->suits().add(QString::fromStdString(ann_.address()));
    EXPECT_EQ(&studio_->suits().current(), studio_->suits().connected()[1]) << "nor from another page";
    EXPECT_EQ(said.count(), 3);
    page().closeWizard();
    performer(0).click();
    EXPECT_EQ(&studio_->suits().current(), studio_->suits().connected()[0]);
}

TEST_F(CalibrateTwoSuits, TheWindowIsNotMadeAnewUnderAWizard) {
    const auto can_change = [this] {
        bool can = false;
        QTimer looking;
        QObject::connect(&looking, &QTimer::timeout, [&] {
            if (auto* dialog = qobject_cast<PreferencesDialog*>(QApplication::activeModalWidget())) {
                can = dialog->language().isEnabled() && dialog->units().isEnabled();
                EXPECT_EQ(dialog->units().toolTip().contains("Finish or leave it first"), !can);
                dialog->accept();
            }
        });
        looking.start(20);
        window_->showPreferences();
        return can;
    };
    page().open(WizardTask::kAccelerometers);
    EXPECT_TRUE(can_change()) << "nothing has begun";
    page().wizard().run()->begin();
    ASSERT_EQ(page().wizard().run()->phase(), WizardRun::Phase::kGuiding);
    EXPECT_FALSE(can_change());
    window_->goTo(Step::kConnect);
    EXPECT_FALSE(can_change()) << "it goes on when Calibrate is shown again";
    window_->goTo(Step::kCalibrate);
    page().closeWizard();
    EXPECT_TRUE(can_change());
}

TEST_F(CalibrateTwoSuits, StepsOfAnUnfinishedCalibrationAreThoseOfTheirSuit) {
    const QString folder = QString::fromStdString(studio_->session().session().calibrationFolder().string());
    const QString take = folder + "/evidence/accelerometers_1_001.noctule";
    QDir().mkpath(folder + "/evidence");
    ASSERT_TRUE(QFile::copy(NOCTULE_TEST_DATA "/takes/tiny_take.noctule", take));
    UnfinishedCalibration unfinished;
    unfinished.started_utc = "2026-03-01T10:00:00Z";
    unfinished.evidence = {{take, 0, {}, {studio_->suit().suit().boards.front().id}}};
    ASSERT_TRUE(
        writeUnfinished(unfinishedPath(folder, "accelerometers", "NB-000001"), "accelerometers", unfinished));
    EXPECT_EQ(unfinishedPath(folder, "accelerometers", ""),
              unfinishedPath(folder, "accelerometers", "NB-000001"));
    EXPECT_TRUE(unfinishedPath(folder, "gyroscopes", "").isEmpty());
    page().open(WizardTask::kAccelerometers);
    WizardRun& run = *page().wizard().run();
    EXPECT_FALSE(run.isUnfinished()) << "Bob's";
    performer(0).click();
    EXPECT_TRUE(run.isUnfinished()) << "Ann's";
    EXPECT_EQ(run.unfinished().stepsDone(), 1);
    performer(1).click();
    EXPECT_FALSE(run.isUnfinished());
    run.begin();
    EXPECT_FALSE(run.guide()->isDone(0));
    EXPECT_TRUE(QFile::exists(take));
}

TEST_F(CalibrateTwoSuits, NobodyIsOfferedWhatWasCalibratedOfTheOther) {
    CalibrationResult found;
    found.calibration = nominalCalibration(studio_->suit().suit());
    found.calibration.created_utc = "2026-03-01T10:00:00Z";
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    EXPECT_EQ(page().useButtons().size(), 1u) << "Bob's own";
    performer(0).click();
    EXPECT_TRUE(page().useButtons().empty()) << "Ann has none";
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    EXPECT_EQ(studio_->calibrations().all().size(), 2u) << "both lie in one folder";
    EXPECT_EQ(page().useButtons().size(), 1u) << "not Bob's";
}

TEST_F(CalibrateTwoSuits, WhatIsNotInUseIsPutAsideFromTheList) {
    CalibrationResult found;
    found.calibration = nominalCalibration(studio_->suit().suit());
    found.calibration.created_utc = "2026-03-01T10:00:00Z";
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    found.calibration.created_utc = "2026-03-01T11:00:00Z";
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    ASSERT_EQ(page().asideButtons().size(), 2u);
    EXPECT_FALSE(page().asideButtons()[0]->isEnabled()) << "the newest is in use";
    page().asideButtons()[1]->click();
    EXPECT_EQ(page().asideButtons().size(), 1u);
    studio_->session().undoStack().undo();
    EXPECT_EQ(page().asideButtons().size(), 2u);
}

TEST_F(CalibrateTwoSuits, TheSessionsOwnCalibrationIsInUseForTheSuitThatHasIt) {
    performer(0).click();
    CalibrationResult found;
    found.calibration = nominalCalibration(studio_->suit().suit());
    found.calibration.created_utc = "2026-03-01T10:00:00Z";
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    const ShelvedCalibration of_ann = studio_->calibrations().all().at(0);
    EXPECT_TRUE(studio_->calibrations().isInForce(of_ann));
    performer(1).click();
    EXPECT_FALSE(studio_->calibrations().isInForce(of_ann));
    EXPECT_TRUE(page().useButtons().empty()) << "Bob's takes are made without it, and it is not offered";
}

TEST_F(CalibrateTwoSuits, AFileOfTheOtherSuitIsTakenOnlyWhenTheOperatorSaysSo) {
    CalibrationResult found;
    found.calibration = nominalCalibration(studio_->suit().suit());
    found.calibration.created_utc = "2026-03-01T10:00:00Z";
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    const QString of_bob = home() + "-bob.json";
    ASSERT_EQ(studio_->calibrations().exportFile(of_bob), "");
    performer(0).click();
    const auto importAndPress = [&](const QString& button) {
        QString asked;
        QTimer::singleShot(0, &page(), [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            asked = box->text() + ' ' + box->informativeText();
            for (QAbstractButton* choice : box->buttons())
                if (choice->text().remove('&') == button)
                    choice->click();
        });
        page().importFile(of_bob);
        return asked;
    };
    const QString asked = importAndPress("Cancel");
    EXPECT_TRUE(asked.contains("-bob.json was made for another suit")) << asked.toStdString();
    EXPECT_TRUE(asked.contains("It belongs to NB-000002; NB-000001 is connected")) << asked.toStdString();
    EXPECT_EQ(studio_->calibrations().fileInForce(), "");
    EXPECT_FALSE(importAndPress("Use it all the same").isEmpty());
    EXPECT_TRUE(studio_->calibrations().fileInForce().contains("-bob"));
    QStringList said;
    for (QWidget* dock : {page().leftDock(), page().rightDock()})
        for (const QLabel* label : dock->findChildren<QLabel*>())
            said << label->text();
    EXPECT_TRUE(said.contains("made for another suit, NB-000002")) << said.join('\n').toStdString();
    EXPECT_TRUE(said.contains("Calibrated for another suit"));
}

TEST_F(CalibrateTwoSuits, AFileThatNamesNoSuitIsOfferedWithThatWord) {
    Calibration old = nominalCalibration(studio_->suit().suit());
    old.created_utc = "2025-03-01T10:00:00Z";
    const QString path = home() + "-old.json";
    QFile file(path);
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(QByteArray::fromStdString(toJson(old).dump()));
    file.close();
    page().importFile(path);
    const auto says = [&] {  // what was added is laid out first
        const auto labels = page().leftDock()->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisibleTo(label->window()) && label->text() == "made for an unknown suit";
        });
    };
    EXPECT_EQ(page().useButtons().size(), 1u);
    EXPECT_TRUE(waitFor(says));
    CalibrationResult found;
    found.calibration = old;
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    ASSERT_EQ(page().useButtons().size(), 2u) << "offered all the same";
    EXPECT_TRUE(waitFor(says));
    performer(0).click();
    EXPECT_EQ(page().useButtons().size(), 1u) << "the one that names Bob's box is not";
}

}  // namespace
}  // namespace noctule::ui
