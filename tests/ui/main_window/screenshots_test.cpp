// SPDX-License-Identifier: Apache-2.0
// Pictures of every page and dialog, for packaging/screenshots.sh: NOCTULE_SCREENSHOTS names the folder that
// they go into, NOCTULE_SCREENSHOT_TAKE a take to show instead of the quick one, NOCTULE_SCREENSHOT_LANGUAGE
// another language than English ("de"). Without the folder nothing is made.
#include <QComboBox>
#include <QDir>
#include <QFileInfo>

#include "core/job/atomic_file.h"
#include "tests/support/shared_meshes.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/language/language.h"
#include "ui/main_window/about_dialog.h"
#include "ui/main_window/jobs_panel.h"
#include "ui/main_window/news_dialog.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/put_on_dialog.h"
#include "ui/main_window/shortcuts_dialog.h"
#include "ui/robot/add_robot_dialog.h"
#include "ui/style/theme.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/views/performer/body_dialog.h"
#include "ui/views/record/shot_list_dialog.h"
#include "ui/views/review/attach_dialog.h"
#include "ui/views/review/process_takes_dialog.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_page.h"
#include "ui/views/session/columns_dialog.h"
#include "ui/views/session/new_session_dialog.h"
#include "ui/views/session/recording_dialog.h"

namespace noctule::ui {
namespace {

class Screenshots : public test::StudioWindow {
protected:
    void SetUp() override {
        folder_of_pictures_ = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
        if (folder_of_pictures_.isEmpty())
            GTEST_SKIP() << "NOCTULE_SCREENSHOTS names no folder";
        QDir().mkpath(folder_of_pictures_);
        StudioWindow::SetUp();
        if (const QString language = qEnvironmentVariable("NOCTULE_SCREENSHOT_LANGUAGE"); !language.isEmpty())
            speak(language);
    }
    void speak(const QString& language) {
        chooseLanguage(studio_->settings(), language);
        applyLanguage(studio_->settings());
        restart();
    }

    void save(QWidget& widget, const QString& name) {
        QTest::qWait(700);  // what loads in the background is there
        EXPECT_TRUE(widget.grab().save(QDir(folder_of_pictures_).filePath(name + ".png")))
            << name.toStdString();
    }
    void openTakeToShow() {
        const QString take = qEnvironmentVariable("NOCTULE_SCREENSHOT_TAKE");
        if (take.isEmpty())
            return openSampleTake();
        QDir().mkpath(home());
        ASSERT_TRUE(studio_->session().create(QDir(home()).filePath("Stage tests"), "Stage tests"));
        studio_->session().importTakes({take});
        ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().shownRun() >= 0; }));
        studio_->time().setTime(studio_->time().duration() * 0.7);
    }
    void picturesOfAllSteps(const QString& look) {
        const std::pair<Step, const char*> steps[] = {
            {Step::kStart, "start"},         {Step::kConnect, "connect"}, {Step::kCalibrate, "calibrate"},
            {Step::kRecord, "record"},       {Step::kReview, "review"},   {Step::kExport, "export"},
            {Step::kPerformer, "performer"}, {Step::kRobot, "robot"}};
        for (const auto& [step, name] : steps) {
            window_->goTo(step);
            save(*window_, QStringLiteral("%1-%2").arg(name, look));
        }
    }
    /// Dark as high as it likes, light as the smallest screen has room for it.
    template <class Dialog, class... Arguments>
    void dialog(const QString& name, Arguments&&... arguments) {
        for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
            Theme::get().setScheme(scheme);
            Dialog shown(arguments..., window_.get());
            if (scheme == Scheme::kLight)
                shown.setMaximumSize(1280, 800 - kTitleBar);
            shown.show();
            EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
            save(shown, name + (scheme == Scheme::kDark ? "-dark" : "-light"));
        }
        Theme::get().setScheme(Scheme::kDark);
    }
    /// Beside the one to show; all have its motion.
    void addTakes() {
        const QString take = studio_->take().path();
        const SessionModel& session = studio_->session();
        ASSERT_TRUE(session.isOpen());
        const size_t before = session.session().takes.size();
        QStringList more;
        for (const char* name : {"fight_001", "fight_002", "turn_003"}) {
            more << folder_.filePath(QString(name) + ".noctule");
            ASSERT_TRUE(QFile::copy(take, more.back()));
        }
        studio_->session().importTakes(more);
        ASSERT_TRUE(waitFor([&] { return session.session().takes.size() == before + 3; }));
        ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    }

    static constexpr int kTitleBar = 40;
    QString folder_of_pictures_;
};

TEST_F(Screenshots, OfEveryPageInBothThemesAndSizes) {
    openTakeToShow();
    for (const QSize size : {QSize(1440, 900), QSize(1280, 800), QSize(1920, 1080)})
        for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
            Theme::get().setScheme(scheme);
            window_->resize(size);
            picturesOfAllSteps(
                QStringLiteral("%1-%2").arg(scheme == Scheme::kDark ? "dark" : "light").arg(size.width()));
        }
}

/// Of a take of several people (NOCTULE_SCREENSHOT_TAKE): what the shown one hears of the others and the
/// room.
TEST_F(Screenshots, OfPairsBetweenPeople) {
    openTakeToShow();
    TakeDocument& take = studio_->take();
    if (!take.isOpen() || take.overview()->parties.size() < 2)
        GTEST_SKIP() << "needs a take of several people";
    window_->goTo(Step::kReview);
    for (int party = 1; party < static_cast<int>(take.overview()->parties.size()); ++party) {
        take.setSourcesOf(party);
        ASSERT_TRUE(waitFor([&] { return take.ranges() != nullptr; }));
        for (const Scheme scheme : {Scheme::kDark, Scheme::kLight})
            for (const QSize size : {QSize(1280, 800), QSize(1440, 900), QSize(1920, 1080)}) {
                Theme::get().setScheme(scheme);
                window_->resize(size);
                save(*window_, QStringLiteral("pairs-%1-%2-%3")
                                   .arg(party)
                                   .arg(scheme == Scheme::kDark ? "dark" : "light")
                                   .arg(size.width()));
            }
    }
    Theme::get().setScale(1.5);
    window_->resize(1280, 800);
    save(*window_, QStringLiteral("pairs-large"));
    Theme::get().setScale(1);
}

/// Several takes chosen: before they are written, and after.
TEST_F(Screenshots, OfExports) {
    openTakeToShow();
    addTakes();
    window_->goTo(Step::kExport);
    auto& page = dynamic_cast<ExportPage&>(window_->page(Step::kExport));
    page.form().setTakes({"fight_001", "fight_002", "sample_001", "turn_003"});
    page.form().run->setCurrentIndex(2);
    const auto saveAll = [&](const char* name) {
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)})
            for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
                Theme::get().setScheme(scheme);
                window_->resize(size);
                save(*window_, QStringLiteral("export-%1-%2-%3")
                                   .arg(name, scheme == Scheme::kDark ? "dark" : "light")
                                   .arg(size.width()));
            }
    };
    saveAll("several");
    page.choosePreset("film");
    saveAll("film");
    page.choosePreset("web");
    page.write();
    ASSERT_TRUE(waitFor([&] { return page.results() && studio_->jobs().idle(); }));
    saveAll("written");
    Theme::get().setScheme(Scheme::kDark);
}

/// Meshes of others, walking in the view.
TEST_F(Screenshots, OfOtherBodies) {
    openTakeToShow();
    window_->goTo(Step::kReview);
    studio_->time().setTime(studio_->time().duration() * 0.8);  // on its way
    const std::pair<const char*, std::string> meshes[] = {
        {"cesiumman", noctule::test::kCesiumMan},
        {"kenney", noctule::test::kKenney},
        {"makehuman", noctule::test::kMakeHuman + "base.obj"}};
    for (const auto& [name, mesh] : meshes) {
        if (!noctule::test::isShared(mesh))
            continue;
        const auto before = studio_->shownBody().worn();
        SessionBody body;
        body.mesh = std::filesystem::absolute(noctule::test::sharedPath(mesh)).string();
        studio_->session().setBody(body);
        const auto is_there = [this, before] {
            return studio_->shownBody().worn() && studio_->shownBody().worn() != before &&
                   studio_->jobs().idle();
        };
        ASSERT_TRUE(waitFor(is_there) || waitFor(is_there)) << mesh;
        QTest::qWait(1000);  // the view has drawn it
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)})
            for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
                Theme::get().setScheme(scheme);
                window_->resize(size);
                save(*window_, QStringLiteral("body-%1-%2-%3")
                                   .arg(name, scheme == Scheme::kDark ? "dark" : "light")
                                   .arg(size.width()));
            }
        dialog<BodyDialog>(QStringLiteral("dialog-body-%1").arg(name), *studio_);
    }
}

TEST_F(Screenshots, AtLargeType) {
    openTakeToShow();
    Theme::get().setScale(1.5);
    picturesOfAllSteps("dark-150");
    Theme::get().setScale(1);
}

TEST_F(Screenshots, OfTheFirstStart) {
    save(*window_, "first-start");
    window_->showTour();
    save(*window_, "tour");
}

TEST_F(Screenshots, OfARecordingToImport) {
    const QString recording =
        NOCTULE_SOURCE_DIR "/../shared/data/imu/qmt_fullbody/full_body_example_data.mat";
    if (!QFileInfo::exists(recording))
        GTEST_SKIP() << "needs ../shared/data/imu";
    dialog<RecordingDialog>("dialog-import-recording", *studio_, QStringList{recording});
}

TEST_F(Screenshots, OfTheColumnsOfATable) {
    const QString table = folder_.filePath("two_sensors.csv");
    noctule::test::writeBytes(
        table.toStdString(),
        "Time (ms),pelvis AccX,pelvis AccY,pelvis AccZ,pelvis GyrX,pelvis GyrY,pelvis GyrZ,"
        "battery\n0,0.1,0.2,9.7,1,2,40,3.9\n10,0.1,0.3,9.8,1,2,41,3.9\n");
    dialog<RecordingDialog>("dialog-import-table", *studio_, QStringList{table});
    dialog<ColumnsDialog>("dialog-columns", "two_sensors.csv", guessColumns(table.toStdString()).value());
}

TEST_F(Screenshots, OfDialogsAboutTakes) {
    openTakeToShow();
    addTakes();
    dialog<ReprocessDialog>("dialog-reprocess", *studio_, *studio_->take().overview());
    dialog<AttachDialog>("dialog-attach", *studio_->take().overview(), "optical/walk_001.bvh");
    dialog<ProcessTakesDialog>("dialog-process-takes-as-made", *studio_, std::nullopt);
    const std::string calibration =
        (studio_->session().session().calibrationFolder() / "motion-2026-01-01.json").string();
    const Calibration of_take = studio_->take().overview()->calibration;
    ASSERT_TRUE(writeFileAtomically(calibration, toJson(of_take).dump(), false));
    studio_->calibrations().use("motion-2026-01-01.json", "Use it");
    dialog<ProcessTakesDialog>("dialog-process-takes", *studio_,
                               std::optional<Actor>(studio_->suit().actor()));
    dynamic_cast<ReviewPage&>(window_->page(Step::kReview)).openFullReport();
    EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        Theme::get().setScheme(size.width() == 1280 ? Scheme::kLight : Scheme::kDark);
        window_->resize(size);
        save(*window_, QStringLiteral("report-%1").arg(size.width()));
    }
    Theme::get().setScheme(Scheme::kDark);
}

TEST_F(Screenshots, OfDialogs) {
    dialog<NewSessionDialog>("dialog-new-session", *studio_);
    dialog<PreferencesDialog>("dialog-preferences", *studio_);
    dialog<PutOnDialog>("dialog-put-on", *studio_);
    dialog<AboutDialog>("dialog-about", "noctule 0.1.0");
    dialog<NewsDialog>("dialog-news");
    dialog<AddRobotDialog>("dialog-robot", RobotChoice());
    dialog<ShotListDialog>("dialog-shot-list", "Walk, straight line x2\nTurn, both ways x3", true);
    dialog<ShortcutsDialog>("dialog-shortcuts", QList<ShortcutGroup>{{"Anywhere", window_->actions().all()}});
    window_->jobsPanel().toggle();
    save(*window_, "jobs");
}

}  // namespace
}  // namespace noctule::ui
