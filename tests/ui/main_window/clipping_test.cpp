// SPDX-License-Identifier: Apache-2.0
// Nothing is cut on any page, dock or dialog: three sizes, 100 and 150 percent, both themes, English and
// German.
#include <QDockWidget>

#include "tests/core/import/example_files.h"
#include "tests/devices/support/test_box.h"
#include "tests/support/files.h"
#include "tests/ui/main_window/clipping_fixture.h"
#include "ui/main_window/about_dialog.h"
#include "ui/main_window/help_window.h"
#include "ui/main_window/news_dialog.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/put_on_dialog.h"
#include "ui/main_window/shortcuts_dialog.h"
#include "ui/main_window/side_docks.h"
#include "ui/models/countdown_setting.h"
#include "ui/robot/add_robot_dialog.h"
#include "ui/views/performer/body_dialog.h"
#include "ui/views/record/record_page.h"
#include "ui/views/record/shot_list_dialog.h"
#include "ui/views/review/attach_dialog.h"
#include "ui/views/review/process_takes_dialog.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_page.h"
#include "ui/views/session/columns_dialog.h"
#include "ui/views/session/motion_dialog.h"
#include "ui/views/session/new_session_dialog.h"
#include "ui/views/session/recording_dialog.h"
#include "ui/views/session/transfer_dialog.h"
#include "ui/views/window_place.h"
#include "ui/wizards/compare_dialog.h"

namespace noctule::ui {
namespace {

/// Of the smallest screen, below the title bar of a dialog.
constexpr QSize kFreeRoom(1280, 760);

class ClippingTest : public test::ClippingFixture {
protected:
    void pagesAreWhole(const QString& look) {
        for (const QSize size : {QSize(1280, 800), QSize(1440, 900), QSize(1920, 1080)}) {
            window_->resize(size);
            for (const Step step : test::kEveryStep) {
                window_->goTo(step);
                window_->sideDocks().reset();
                QTest::qWait(60);
                expectWholeAndItsLanguage(*window_, QStringLiteral("%1, %2x%3, page %4")
                                                        .arg(look)
                                                        .arg(size.width())
                                                        .arg(size.height())
                                                        .arg(window_->page(step).title()));
                EXPECT_EQ(window_->size(), size) << look.toStdString();
            }
        }
    }

    /// Names of bones and columns as a file has them, of calibration files and of libraries.
    static bool showsWordsOfOthers(const QWidget& dialog) {
        return qobject_cast<const MotionDialog*>(&dialog) || qobject_cast<const ColumnsDialog*>(&dialog) ||
               qobject_cast<const AboutDialog*>(&dialog) || qobject_cast<const CompareDialog*>(&dialog);
    }

    template <class Dialog, class... Arguments>
    void dialogIsWhole(const char* name, Arguments&&... arguments) {
        inEveryLook([&](const QString& look) {
            window_->resize(1280, 800);
            Dialog dialog(arguments..., window_.get());
            dialog.show();
            EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
            QTest::qWait(30);
            const QString where = QStringLiteral("%1, %2").arg(name, look);
            if (showsWordsOfOthers(dialog))
                expectWhole(dialog, where);
            else
                expectWholeAndItsLanguage(dialog, where);
            const QSize size = dialog.size();  // one has a member of the name height
            EXPECT_LE(size.width(), kFreeRoom.width()) << where.toStdString();
            EXPECT_LE(size.height(), kFreeRoom.height()) << where.toStdString();
        });
    }
};

TEST_P(ClippingTest, PagesWithoutASession) {
    inEveryLook([this](const QString& look) { pagesAreWhole(look); });
}

TEST_P(ClippingTest, PagesWithATake) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    inEveryLook([this](const QString& look) { pagesAreWhole(look); });
}

/// One of them, on one carrier and then on two.
TEST_P(ClippingTest, ConnectAndRecordWithTwoSuits) {
    using noctule::test::TestBox;
    TestBox first({.loops = true, .serial = "NB-000123"});
    auto second = std::make_unique<TestBox>(TestBox::Options{.loops = true, .serial = "NB-000087"});
    ASSERT_TRUE(studio_->session().create(folder_.filePath("stage"), "Stage"));
    LiveSuits& suits = studio_->suits();
    const auto add = [&](const TestBox& box) {
        suits.add(QString::fromStdString(box.address()));
        ASSERT_TRUE(waitFor([&] { return suits.current().suit.phase() == LiveSuit::Phase::kLooking; }));
    };
    add(first);
    add(*second);
    const auto areWhole = [&](const QString& what) {
        inEveryLook([&](const QString& look) {
            for (const Step step : {Step::kConnect, Step::kRecord}) {
                window_->resize(1280, 800);
                window_->goTo(step);
                window_->sideDocks().reset();
                QTest::qWait(60);
                expectWholeAndItsLanguage(*window_,
                                          look + ", " + what + ", page " + window_->page(step).title());
                EXPECT_EQ(window_->size(), QSize(1280, 800)) << look.toStdString();
            }
        });
    };
    areWhole("two suits on one carrier");
    suits.current().suit.disconnectSuit();
    second =
        std::make_unique<TestBox>(TestBox::Options{.loops = true, .serial = "NB-000087", .drive_hz = 48000});
    add(*second);
    RecordRun& run = dynamic_cast<RecordPage&>(window_->page(Step::kRecord)).run();
    CountdownSetting::get().setSeconds(0);
    run.setTones(false);
    ASSERT_TRUE(waitFor([&] { return run.obstacle().may_record_anyway || !run.obstacle(); }));
    run.press();
    run.recordAnyway();  // where something is wanting
    ASSERT_TRUE(waitFor([&] { return suits.phase() == LiveSuit::Phase::kRecording; }));
    areWhole("a take of two suits");
    run.setOpensReview(false);
    run.stop();
    ASSERT_TRUE(waitFor([&] { return !suits.isTakeOpen() && studio_->jobs().idle(); }));
}

TEST_P(ClippingTest, TheFullReport) {
    openSampleTake();
    dynamic_cast<ReviewPage&>(window_->page(Step::kReview)).openFullReport();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    inEveryLook([this](const QString& look) {
        window_->resize(1280, 800);
        QTest::qWait(100);
        expectWholeAndItsLanguage(*window_, look + ", report");
    });
}

TEST_P(ClippingTest, Dialogs) {
    dialogIsWhole<NewSessionDialog>("new session", *studio_);
    dialogIsWhole<PreferencesDialog>("preferences", *studio_);
    dialogIsWhole<PutOnDialog>("put on", *studio_);
    dialogIsWhole<AboutDialog>("about", "noctule 0.1.0");
    dialogIsWhole<NewsDialog>("news");
    dialogIsWhole<HelpWindow>("documents");
    dialogIsWhole<MotionDialog>("import motion", *studio_,
                                QStringLiteral(NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh"));
    const QString recording = folder_.filePath("walk_0001.txt");
    noctule::test::writeBytes(recording.toStdString(),
                              noctule::test::xsensExample({1, 2, 3, 4, 5, 6, 7, 8}, '\t', true));
    dialogIsWhole<RecordingDialog>("import recording", *studio_, QStringList{recording});
    const QString table = folder_.filePath("two_sensors.csv");
    noctule::test::writeBytes(
        table.toStdString(),
        "Time (ms),pelvis AccX,pelvis AccY,pelvis AccZ,pelvis GyrX,pelvis GyrY,pelvis GyrZ,"
        "battery\n0,0.1,0.2,9.7,1,2,40,3.9\n10,0.1,0.3,9.8,1,2,41,3.9\n");
    dialogIsWhole<RecordingDialog>("import table", *studio_, QStringList{table});
    dialogIsWhole<ColumnsDialog>("columns", "two_sensors.csv", guessColumns(table.toStdString()).value());
    dialogIsWhole<AddRobotDialog>("robot", RobotChoice());
    dialogIsWhole<ShotListDialog>("shot list", "Walk, straight line x2\nTurn, both ways x3", true);
    dialogIsWhole<ShortcutsDialog>("shortcuts", QList<ShortcutGroup>{{"Anywhere", window_->actions().all()}});
}

TEST_P(ClippingTest, DialogsAboutTakes) {
    openSampleTake();
    dialogIsWhole<ReprocessDialog>("process", *studio_, *studio_->take().overview());
    dialogIsWhole<AttachDialog>("attach", *studio_->take().overview(), "optical/walk_001.bvh");
    dialogIsWhole<ProcessTakesDialog>("process takes", *studio_, std::nullopt);
    dialogIsWhole<BodyDialog>("body", *studio_);
    dialogIsWhole<TransferDialog>("to another session", *studio_, "walk_001", SessionModel::Transfer::kMove);
}

TEST_P(ClippingTest, TwoCalibrationsCompared) {
    openSampleTake();
    CalibrationResult in_use;
    in_use.calibration = nominalCalibration(studio_->take().overview()->suit);
    ASSERT_EQ(studio_->calibrations().save(in_use, "accelerometers"), "");
    ShelvedCalibration other{"accelerometers-2025-12-01.json", in_use.calibration};
    other.calibration.created_utc = "2025-12-01T10:00:00Z";
    ASSERT_FALSE(other.calibration.boards.empty());
    for (BoardCalibration& board : other.calibration.boards) {
        board.gyro.zero_counts += Vector3d(0.8, -0.5, 0.2);
        board.accel.matrix *= 1.0004;
    }
    dialogIsWhole<CompareDialog>("compare", *studio_, other);
}

/// Another dialog is smaller than the window; what belongs to it has the window's room all the same.
TEST_P(ClippingTest, ADialogOfADialogHasTheRoomOfTheWindow) {
    window_->resize(1280, 800);
    ShotListDialog first("Walk", true, window_.get());
    const NewsDialog second(&first);
    EXPECT_EQ(roomOf(second), kFreeRoom);
    EXPECT_EQ(roomOf(second), roomOf(first));
}

INSTANTIATE_TEST_SUITE_P(Languages, ClippingTest, testing::Values("en", "de"));

TEST(WindowPlaceTest, AWindowIsNeverLargerThanTheDesktop) {
    const QRect screen(0, 0, 1280, 800), with_panel(0, 27, 1280, 773);
    const WindowPlace first = placeWithin({0, 0, 1440, 900}, screen);
    EXPECT_TRUE(first.maximised);
    EXPECT_TRUE(screen.contains(first.content));
    EXPECT_LT(first.content.height(), 800) << "room for the title bar";
    EXPECT_TRUE(with_panel.contains(placeWithin({0, 0, 1440, 900}, with_panel).content));
}

TEST(WindowPlaceTest, AWindowFromALargerDesktopComesBackInside) {
    const QRect screen(0, 0, 1920, 1080);
    const WindowPlace place = placeWithin({2600, 1300, 1440, 900}, screen);
    EXPECT_FALSE(place.maximised) << "it only stood elsewhere";
    EXPECT_EQ(place.content.size(), QSize(1440, 900));
    EXPECT_TRUE(screen.contains(place.content));
    EXPECT_EQ(placeWithin({100, 100, 1440, 900}, screen).content, QRect(100, 100, 1440, 900))
        << "what fits stays";
}

}  // namespace
}  // namespace noctule::ui
