// SPDX-License-Identifier: Apache-2.0
// Several takes are processed from their dialog; the screen goes on while a take makes it wait.
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QTimer>
#include <fstream>

#include "core/recording/database.h"
#include "core/recording/take_edit.h"
#include "tests/core/simulation/swaying_pair.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/views/report/full_report.h"
#include "ui/views/review/process_takes_dialog.h"
#include "ui/views/review/review_sidebar.h"

namespace noctule::ui {
namespace {

using ProcessTakes = test::ReviewedSession;

TEST_F(ProcessTakes, ATakeThatIsHeldDoesNotHoldTheScreenUp) {
    addTake("swing_002");
    ProcessTakesDialog dialog(*studio_, std::nullopt);
    dialog.tick({"swing_001", "swing_002"});
    // Whoever opens it waits for seconds.
    const auto other = Database::open(takePath("swing_001").toStdString(), Access::kReadWrite);
    ASSERT_TRUE(other && other->execute("BEGIN EXCLUSIVE"));
    dialog.process();
    ASSERT_FALSE(studio_->jobs().all().empty());
    Job* job = studio_->jobs().all().back();
    EXPECT_EQ(job->title(), "Processing swing_001");
    EXPECT_EQ(job->state(), Job::State::kRunning) << "process() waited for the take";
    ASSERT_TRUE(other->execute("ROLLBACK"));
    job->cancel();
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kCancelled; }));
    ASSERT_TRUE(waitFor([&] { return studio_->jobs().all().back()->title() == "Processing swing_002"; }))
        << "the next one has its turn";
    studio_->jobs().all().back()->cancel();
}

/// Drops the results of a take; `uncalibrated`: and what its suit is known to be.
void makeUnprocessed(const std::string& path, bool uncalibrated) {
    auto take = Take::open(path, Access::kReadWrite);
    ASSERT_TRUE(take);
    const auto runs = take->derivedRuns();
    ASSERT_TRUE(runs);
    auto edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit);
    for (const DerivedRun& run : *runs)
        ASSERT_TRUE(edit->dropRun(run.run));
    if (uncalibrated) {
        ASSERT_TRUE(edit->addCalibration(nominalCalibration(*take->suit())));
    }
    ASSERT_TRUE(edit->commit());
}

/// When the calibration of a take's last result was made.
std::string calibrationOfLastResult(const std::string& path) {
    const auto take = Take::open(path);
    const auto runs = take->derivedRuns();
    for (auto run = runs->rbegin(); run != runs->rend(); ++run)
        if (run->kind == "pose" && run->calibration_id)
            return take->calibration(*run->calibration_id)->created_utc;
    return "none";
}

TEST_F(ProcessTakes, FromTheMenuTakesKeepTheirOwnCalibrationAndTheOneInUseIsForThoseWithout) {
    addTake("swing_002");
    const std::string with = takePath("swing_001").toStdString(),
                      without = takePath("swing_002").toStdString();
    auto in_use = Take::open(with)->calibrationInForce()->value;
    const std::string own = in_use.created_utc;
    in_use.created_utc = "2030-01-01T00:00:00Z";
    std::ofstream(studio_->session().session().calibrationFolder() / "later.json") << toJson(in_use).dump();
    studio_->session().setCalibration("later.json", "test");
    ASSERT_TRUE(waitFor([this] { return studio_->calibrations().inForce() && jobsAreDone(); }));
    makeUnprocessed(with, false);
    makeUnprocessed(without, true);
    for (const std::string& path : {with, without})
        studio_->session().refresh(QString::fromStdString(path));

    FullReport report(*studio_);
    ReviewSidebar sidebar(*studio_, report);
    auto* menu = sidebar.findChild<QMenu*>();
    ASSERT_TRUE(menu);
    emit menu->aboutToShow();
    const auto actions = menu->actions();
    const auto process = std::ranges::find(actions, QString("Process all unprocessed takes"), &QAction::text);
    ASSERT_NE(process, actions.end());
    QString said;
    QTimer::singleShot(0, &sidebar, [&] {
        auto* dialog = qobject_cast<ProcessTakesDialog*>(QApplication::activeModalWidget());
        ASSERT_TRUE(dialog);
        EXPECT_EQ(dialog->ticked(), (QStringList{"swing_001", "swing_002"}));
        for (const QLabel* label : dialog->findChildren<QLabel*>())
            said += label->text();
        dialog->accept();
    });
    (*process)->trigger();
    EXPECT_TRUE(said.contains("one recorded without gets “later”"));
    ASSERT_TRUE(waitFor([&] { return sidebar.unprocessedTakes().isEmpty() && jobsAreDone(); }));
    EXPECT_EQ(calibrationOfLastResult(with), own);
    EXPECT_EQ(calibrationOfLastResult(without), "2030-01-01T00:00:00Z");
}

TEST_F(ProcessTakes, TakesOfSeveralKeepWhatEachOneHas) {
    const std::string pair = outsideFile("pair.noctule").toStdString();
    ASSERT_TRUE(noctule::test::writeSwayingPair(pair));
    const PartsOfOne own{Calibration{}, defaultActor()};
    const ProcessRequest of_one =
        Studio::accurateRequest(takePath("swing_001").toStdString(), own, JobContext{});
    EXPECT_TRUE(of_one.calibration && of_one.actor);
    EXPECT_EQ(of_one.tracker.smoother, Smoother::kFull);
    const ProcessRequest of_two = Studio::accurateRequest(pair, own, JobContext{});
    EXPECT_FALSE(of_two.calibration || of_two.actor);
}

}  // namespace
}  // namespace noctule::ui
