// SPDX-License-Identifier: Apache-2.0
// Nothing is cut where a page tells of trouble: damaged takes, links that stall or come back elsewhere, a
// calibration of another suit, a walk without a take, a take whose boards lost frames.
#include <QMessageBox>
#include <QSignalSpy>
#include <QTimer>

#include "tests/devices/support/answerer.h"
#include "tests/devices/support/test_box.h"
#include "tests/support/take_files.h"
#include "tests/ui/main_window/clipping_fixture.h"
#include "ui/main_window/side_docks.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/room_page.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class TroublesWhole : public test::ClippingFixture {
protected:
    template <class Page>
    Page& page(Step step) {
        return dynamic_cast<Page&>(window_->page(step));
    }
    void lookAt(Step step, const QString& what) {
        inEveryLook([&](const QString& look) {
            window_->resize(1280, 800);
            window_->goTo(step);
            window_->sideDocks().reset();
            QTest::qWait(60);
            expectWholeAndItsLanguage(*window_, look + ", " + what);
            EXPECT_EQ(window_->size(), QSize(1280, 800)) << look.toStdString();
        });
    }
    void add(const TestBox& box) {
        studio_->suits().add(QString::fromStdString(box.address()));
        ASSERT_TRUE(waitFor([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    }
    /// Opens the left panel, which gives room to the page where there is little of it.
    void lookAtLeftPanel(Step step, const QString& what) {
        inEveryLook([&](const QString& look) {
            window_->resize(1280, 800);
            window_->goTo(step);
            window_->sideDocks().reset();
            QAction* opens = window_->sideDocks().left().toggleViewAction();
            if (!opens->isChecked())
                opens->trigger();
            QTest::qWait(60);
            expectWholeAndItsLanguage(*window_, look + ", " + what);
        });
    }
    bool isStalled() { return studio_->suit().status()->link == LinkState::kStalled; }
};

TEST_P(TroublesWhole, ExportOfADamagedTake) {
    openSampleTake();
    const QString copy = folder_.filePath("kick_002.noctule");
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    ASSERT_TRUE(QFile::copy(studio_->take().path(), copy));
    const QString folder = QFileInfo(studio_->take().path()).path();
    studio_->session().importTakes({copy});
    ASSERT_TRUE(waitFor([&] {
        return QFile::exists(folder + "/kick_002.noctule") && studio_->take().shownRun() >= 0 &&
               studio_->jobs().idle();
    }));
    noctule::test::damageRowsOf((folder + "/kick_002.noctule").toStdString(), "pose");
    window_->goTo(Step::kExport);
    auto& exports = page<ExportPage>(Step::kExport);
    const QSignalSpy torn(studio_.get(), &Studio::tornTake);
    exports.choosePreset("blender");
    exports.form().setTakes({"kick_002"});
    ASSERT_TRUE(waitFor([&] { return exports.writeButton()->isEnabled(); }));
    exports.writeButton()->click();
    ASSERT_TRUE(waitFor([&] { return exports.results().has_value() && studio_->jobs().idle(); }));
    ASSERT_EQ(torn.count(), 1);
    ASSERT_GT(window_->notices().count(), 0) << "what can be read may be saved";
    lookAt(Step::kExport, "a damaged take");
}

TEST_P(TroublesWhole, ABoxThatAnswersAtAnotherAddress) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("stage"), "Stage"));
    auto before = std::make_unique<TestBox>(TestBox::Options{.loops = true});
    add(*before);
    const TestBox now({.loops = true});
    before.reset();
    ASSERT_TRUE(waitFor([this] { return studio_->suit().isLost(); }));
    auto announced = noctule::test::testAnnouncement();
    announced.tcp_port = now.port();
    noctule::test::Answerer answerer(announced);
    window_->goTo(Step::kConnect);
    studio_->finder().start({answerer.port(), false});
    DevicesPanel& devices = page<ConnectPage>(Step::kConnect).devices();
    const QString again = DevicesPanel::tr("Connect again");
    ASSERT_TRUE(
        waitFor([&] { return !devices.cards().empty() && devices.cards()[0]->words().action == again; }));
    lookAtLeftPanel(Step::kConnect, "answers at another address");
    EXPECT_EQ(devices.cards()[0]->words().action, again) << "until now";
}

TEST_P(TroublesWhole, ALinkThatStallsWhileOneRecords) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("stage"), "Stage"));
    TestBox box({.loops = true});
    add(box);
    box.stutter(true);
    inEveryLook([&](const QString& look) {
        window_->resize(1280, 800);
        window_->goTo(Step::kRecord);
        window_->sideDocks().reset();
        QTest::qWait(60);
        // It comes and goes: at some time it stalls and all is laid out.
        QStringList cut;
        EXPECT_TRUE(waitFor([&] {
            if (!isStalled())
                return false;
            cut = test::Clipping::in(*window_);
            return isStalled() && cut.isEmpty();
        })) << look.toStdString()
            << ": " << cut.join('\n').toStdString();
    });
}

TEST_P(TroublesWhole, CalibrationsOfASessionAndOfAnotherSuit) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("duo"), "duo"));
    const TestBox ann({.loops = true, .serial = "NB-000001", .drive_hz = 40000}),
        bob({.loops = true, .serial = "NB-000002", .drive_hz = 48000});
    add(ann);
    CalibrationResult found;
    found.calibration = nominalCalibration(studio_->suit().suit());
    found.calibration.created_utc = "2026-03-01T10:00:00Z";
    ASSERT_EQ(studio_->calibrations().save(found, "accelerometers"), "");
    const QString of_ann = folder_.filePath("messung-2026-03-01-anzug-von-ann-im-saal.json");
    ASSERT_EQ(studio_->calibrations().exportFile(of_ann), "");
    add(bob);
    found.calibration = nominalCalibration(studio_->suit().suit());
    for (const char* day : {"2026-03-02T10:00:00Z", "2026-03-03T10:00:00Z"}) {
        found.calibration.created_utc = day;
        ASSERT_EQ(studio_->calibrations().save(found, "accelerometers"), "");
    }
    lookAtLeftPanel(Step::kCalibrate, "history");
    auto& calibrate = page<CalibratePage>(Step::kCalibrate);
    inEveryLook([&](const QString& look) {
        bool asked = false;
        QTimer::singleShot(0, &calibrate, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            asked = true;
            expectWholeAndItsLanguage(*box, look + ", question of another suit");
            EXPECT_LE(box->width(), 1280);
            EXPECT_LE(box->height(), 760);
            box->reject();
        });
        calibrate.importFile(of_ann);
        EXPECT_TRUE(asked) << look.toStdString();
    });
    QTimer::singleShot(0, &calibrate, [] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_NE(box, nullptr);
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == QMessageBox::AcceptRole)
                button->click();
    });
    calibrate.importFile(of_ann);
    ASSERT_TRUE(studio_->calibrations().fileInForce().contains("von-ann"));
    lookAtLeftPanel(Step::kCalibrate, "history with a long name and another suit");
}

TEST_P(TroublesWhole, AWalkThatBroughtNoTake) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("room"), "Room"));
    window_->goTo(Step::kCalibrate);
    auto& calibrate = page<CalibratePage>(Step::kCalibrate);
    calibrate.openRoom();
    calibrate.room().walk().begin();  // nobody is there
    ASSERT_FALSE(calibrate.room().walk().trouble().isEmpty());
    ASSERT_FALSE(calibrate.room().findChildren<ProblemCard*>().isEmpty());
    lookAt(Step::kCalibrate, "a walk without a take");
}

INSTANTIATE_TEST_SUITE_P(Languages, TroublesWhole, testing::Values("en", "de"));

}  // namespace
}  // namespace noctule::ui
