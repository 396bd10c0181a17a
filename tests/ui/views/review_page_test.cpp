// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/review_page.h"

#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "tests/ui/views/reviewed_session.h"
#include "ui/models/part_names.h"
#include "ui/plots/timeline.h"
#include "ui/scene/scene_tools.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/scene_words.h"
#include "ui/style/words.h"
#include "ui/views/report/joint_table.h"
#include "ui/views/report/report_panel.h"
#include "ui/views/review/choice_row.h"
#include "ui/views/review/markers_panel.h"
#include "ui/views/review/notes_panel.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_center.h"
#include "ui/views/review/review_sidebar.h"
#include "ui/views/review/run_list.h"
#include "ui/views/review/run_row.h"
#include "ui/views/review/scene_area.h"
#include "ui/views/review/take_notes.h"
#include "ui/views/review_words.h"
#include "ui/views/take_list.h"
#include "ui/widgets/button.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

class ReviewPageTest : public test::ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        if (HasFatalFailure())
            return;
        window_ = std::make_unique<QWidget>();
        page_ = new ReviewPage(*studio_);
        auto* row = new QHBoxLayout(window_.get());
        for (QWidget* part : {page_->leftDock(), static_cast<QWidget*>(page_), page_->rightDock()}) {
            row->addWidget(part);
            part->show();
        }
        window_->resize(1440, 860);
        window_->show();
        page_->enter();
        openTake("swing_001");
    }
    void TearDown() override {
        waitFor([this] { return jobsAreDone(); });
        window_.reset();
        ReviewedSession::TearDown();
    }

    const SessionTake& take() const { return studio_->session().session().takes[0]; }
    bool says(const QString& words) const {
        for (const QLabel* label : page_->reportPanel().findChildren<QLabel*>())
            if (label->text().contains(words))
                return true;
        return false;
    }

    std::unique_ptr<QWidget> window_;
    ReviewPage* page_ = nullptr;
};

TEST_F(ReviewPageTest, JudgesTheTake) {
    ASSERT_EQ(page_->sidebar().runs().count(), 1);
    EXPECT_TRUE(page_->sidebar().runs().row(0)->isChecked());
    EXPECT_EQ(page_->sidebar().runs().row(0)->number(), "1");
    EXPECT_TRUE(page_->sidebar().runs().row(0)->detail().contains("shown"));
    const auto verdict = studio_->take().verdict();
    ASSERT_TRUE(verdict->mean_error_deg);
    EXPECT_TRUE(says(QString::number(*verdict->mean_error_deg, 'f', 1) + QChar(0xB0)));
    EXPECT_EQ(page_->reportPanel().joints().model()->rowCount(), static_cast<int>(verdict->joints.size()));
}

TEST_F(ReviewPageTest, ReprocessedResultIsShownAndComparedWithTheEarlierOne) {
    ReprocessDialog dialog(*studio_, *studio_->take().overview());
    EXPECT_TRUE(dialog.root_given->isChecked()) << "as the last result was made";
    dialog.accelerometers->setChecked(false);
    dialog.distances->setChecked(false);
    EXPECT_EQ(dialog.request().tracker.sensors.gyroscopes, true);
    page_->process(dialog.request());
    ASSERT_TRUE(waitFor([this] { return page_->sidebar().runs().count() == 2; }));
    const TakeDocument& take = studio_->take();
    EXPECT_EQ(take.shownRun(), 1);
    EXPECT_EQ(take.overview()->runs[1].settings.sensors, "G");
    EXPECT_EQ(take.comparedRun(), 0);
    EXPECT_EQ(page_->sidebar().runs().row(1)->text(), "Gyroscopes only, smoothed");
    EXPECT_EQ(page_->sidebar().runs().row(0)->number(), "1") << "it keeps its number";
    EXPECT_EQ(page_->sidebar().runs().row(1)->number(), "2");
    ASSERT_TRUE(waitFor([this] { return page_->sidebar().runs().row(0)->detail().contains("mean"); }))
        << "all results are compared in the background";

    ComposedScene composed;
    composed.has_ghost = true;
    const std::vector<SceneLegend> legends = takeLegends(studio_->take(), composed, SceneLayers());
    ASSERT_EQ(legends.size(), 2u);
    EXPECT_EQ(legends[0].text, "Result 2");
    EXPECT_EQ(legends[1].text, "Result 1") << "the picture's numbers are those of the list";

    page_->center().scenes().setSideBySide(true);
    EXPECT_TRUE(page_->center().scenes().isSideBySide());
    QTest::mouseClick(page_->sidebar().runs().row(0), Qt::LeftButton);
    EXPECT_EQ(take.comparedRun(), -1);
    EXPECT_FALSE(page_->center().scenes().isSideBySide()) << "nothing is left beside it";
    QTest::mouseClick(page_->sidebar().runs().row(1), Qt::LeftButton);
    EXPECT_EQ(take.shownRun(), 1) << "one is always shown";
}

TEST_F(ReviewPageTest, TheSplitButtonAndTheToolsLieBesideEachOther) {
    studio_->take().setComparedRun(TakeDocument::kReference);
    SceneArea& scenes = page_->center().scenes();
    const auto* split = scenes.findChild<ToolButton*>({}, Qt::FindDirectChildrenOnly);
    for (const int width : {1100, 1280, 1440})
        for (const bool side_by_side : {false, true}) {
            window_->resize(width, 860);
            scenes.setSideBySide(side_by_side);
            QTest::qWait(50);
            ASSERT_EQ(scenes.isSideBySide(), side_by_side);
            for (const SceneView* view : {&scenes.shown(), scenes.compared()})
                if (view && view->isVisible()) {
                    const auto* tools = view->findChild<SceneTools*>();
                    const QRect place(tools->mapTo(&scenes, QPoint()), tools->size());
                    EXPECT_FALSE(place.intersects(split->geometry()))
                        << width << ": tools end at " << place.right() << ", the button begins at "
                        << split->x();
                }
        }
}

TEST_F(ReviewPageTest, ReprocessingFitsTheSmallestScreen) {
    constexpr int kScreen = 800, kTitleBar = 40;
    ReprocessDialog dialog(*studio_, *studio_->take().overview());
    dialog.paper->setChecked(true);
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    EXPECT_LE(dialog.height(), kScreen - kTitleBar);
    EXPECT_LE(dialog.minimumSizeHint().height(), kScreen - kTitleBar);
}

TEST_F(ReviewPageTest, AProcessingNeedsSensors) {
    ReprocessDialog dialog(*studio_, *studio_->take().overview());
    for (ChoiceRow* sensor : {dialog.accelerometers, dialog.gyroscopes, dialog.distances})
        sensor->setChecked(false);
    EXPECT_TRUE(dialog.actionButton()->toolTip().contains("at least one"));
    dialog.distances->setChecked(true);
    dialog.paper->setChecked(true);
    EXPECT_EQ(dialog.name->placeholderText(), "D paper");
    EXPECT_EQ(dialog.request().tracker.estimator, kPaperEstimator);
}

TEST_F(ReviewPageTest, SmoothingIsAskedForAndThePapersFilterHasNone) {
    ReprocessDialog dialog(*studio_, *studio_->take().overview());
    EXPECT_EQ(dialog.request().tracker.smoother, Smoother::kFull) << "the most accurate is the usual one";
    dialog.not_smoothed->setChecked(true);
    EXPECT_EQ(dialog.request().tracker.smoother, Smoother::kNone) << "as live stays a choice";
    dialog.most_probable->setChecked(true);
    EXPECT_EQ(dialog.request().tracker.smoother, Smoother::kBatch);
    dialog.smoothed_half_second->setChecked(true);
    EXPECT_EQ(dialog.request().tracker.smoother, Smoother::kLag);
    dialog.paper->setChecked(true);
    EXPECT_EQ(dialog.request().tracker.smoother, Smoother::kNone);
    EXPECT_FALSE(dialog.smoothed_whole->button()->isEnabled());
    EXPECT_FALSE(dialog.most_probable->button()->isEnabled());
    EXPECT_EQ(dialog.request().detector, Detector::kInflection) << "the paper's";
    const bool has_sound = studio_->take().overview()->level == TakeLevel::kSignal;
    dialog.ours->setChecked(true);
    EXPECT_EQ(dialog.request().detector, has_sound ? Detector::kMatched : Detector::kInflection);
    EXPECT_EQ(dialog.matched->button()->isEnabled(), has_sound);
}

TEST_F(ReviewPageTest, TheFirstProcessingIsCalledSoAndIsTheMostAccurate) {
    TakeOverview fresh = *studio_->take().overview();
    fresh.runs.clear();
    fresh.level = TakeLevel::kSignal;
    fresh.lack = {};
    ReprocessDialog dialog(*studio_, fresh);
    EXPECT_EQ(dialog.windowTitle(), "Process swing_001");
    EXPECT_EQ(dialog.actionButton()->text(), "Process");
    EXPECT_EQ(dialog.request().detector, Detector::kMatched);
    EXPECT_EQ(dialog.request().tracker.smoother, Smoother::kFull);
    EXPECT_EQ(ReprocessDialog(*studio_, *studio_->take().overview()).actionButton()->text(), "Reprocess");
}

TEST_F(ReviewPageTest, AMissingCalibrationIsSaidBeforeProcessing) {
    TakeOverview overview = *studio_->take().overview();
    overview.level = TakeLevel::kSignal;
    overview.lack = lackOf(overview.suit, Calibration{});
    ReprocessDialog dialog(*studio_, overview);
    const auto told = [&dialog] {
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            if (label->text().startsWith("The result will"))
                return label->text();
        return QString();
    };
    EXPECT_EQ(told(),
              "The result will not be usable: there is no calibration of the source offsets, the "
              "accelerometers, the gyroscopes and the rest pose. Choose one that has it.");
    QFile file(outsideFile("c.json"));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(QByteArray::fromStdString(toJson(studio_->take().overview()->calibration).dump()));
    file.close();
    dialog.setCalibrationFile(file.fileName());
    EXPECT_EQ(told(), "");
}

TEST_F(ReviewPageTest, ACalibrationThatCannotBeReadIsForgottenWithAnotherChoice) {
    ReprocessDialog dialog(*studio_, *studio_->take().overview());
    const auto tells = [&dialog] {
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            if (label->text().contains("nothing.json"))
                return true;
        return false;
    };
    dialog.setCalibrationFile(outsideFile("nothing.json"));
    EXPECT_TRUE(tells());
    dialog.gyroscopes->setChecked(!dialog.gyroscopes->isChecked());
    EXPECT_TRUE(tells()) << "the file is still the one that was asked for";
    dialog.calibration_in_force->button()->click();
    EXPECT_FALSE(tells());
}

TEST_F(ReviewPageTest, AnUncalibratedTakeIsDiagnosedAndNoTitleLacksItsName) {
    const TakeOverview& overview = *studio_->take().overview();
    TakeVerdict verdict;
    verdict.grade = Grade::kNotUsable;
    verdict.lack = lackOf(overview.suit, Calibration{});
    verdict.reasons = {VerdictReason::kNotCalibrated};
    EXPECT_EQ(gradeInWords(verdict.grade) + ": " + gradeExplained(verdict),
              "Not usable: This take has no calibration. Process it with one.");
    const auto problems = problemsInWords(verdict, overview);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].title, "This take has no calibration");
    EXPECT_TRUE(problems[0].processes);
    verdict = {};
    verdict.grade = Grade::kUsable;
    verdict.reasons = {VerdictReason::kSupport};
    EXPECT_EQ(problemsInWords(verdict, overview)[0].title, "No joint was backed by ranges");
    verdict.backed_share = 0.31;
    EXPECT_EQ(problemsInWords(verdict, overview)[0].title,
              "Ranges backed the joints only 31\u00A0% of the time");
    verdict.worst_joint = "LeftLeg";
    EXPECT_EQ(problemsInWords(verdict, overview)[0].title, "Left knee is less certain");
}

TEST_F(ReviewPageTest, TheVerdictAgreesWithItsFigure) {
    TakeVerdict verdict;
    verdict.backed_share = 0.56;
    EXPECT_TRUE(gradeExplained(verdict).contains("56\u00A0% of the time"))
        << gradeExplained(verdict).toStdString();
    EXPECT_FALSE(gradeExplained(verdict).contains("from start to end"));
}

TEST_F(ReviewPageTest, NotesAreInTheOperatorsWords) {
    TakeOverview overview = *studio_->take().overview();
    overview.sample_rate_hz = 150'000;
    const int hand = 1;
    const QString place =
        boardName(overview.suit.boards[1], NameCase::kInside) + QStringLiteral(" (board 2)");
    overview.silences = {{hand, 7.8, 13.0}, {hand, 20.0, {}}};
    overview.notes = {{"", "0:03.2 left heel slips"},
                      {"", "Driver box, at sample 1168800: board lost: board r_hand does not answer"},
                      {"", "Driver box, at sample 2250000: battery low: 11 V"},
                      {"", "0:16.5 Driver box: 12 V"},
                      {"", "second try"}};
    EXPECT_EQ(takeNoteLines(overview),
              (QStringList{"0:03.2 left heel slips", "0:07.8 " + place + " fell silent; back at 0:13.0",
                           "0:15.0 driver box: 11 V", "0:16.5 driver box: 12 V",
                           "0:20.0 " + place + " fell silent", "second try"}));
}

TEST_F(ReviewPageTest, ChoosingAJointChoosesItEverywhere) {
    JointTable& table = page_->reportPanel().joints();
    table.selectRow(2);
    table.setCurrentIndex(table.model()->index(2, 0));
    EXPECT_FALSE(studio_->selection().joint().isEmpty());
    studio_->selection().setJoint("LeftLeg");
    EXPECT_EQ(table.currentIndex().sibling(table.currentIndex().row(), 0).data().toString(), "Left knee");
    table.copy();
    EXPECT_TRUE(QGuiApplication::clipboard()->text().contains("Left knee\t"));
}

TEST_F(ReviewPageTest, InAndOutAreKeptPerTakeAndComeBackWithUndo) {
    studio_->time().setRange(1, 2);
    ASSERT_TRUE(waitFor([this] { return take().out_s > 0; }));
    EXPECT_NEAR(take().in_s, 1, 1e-9);
    EXPECT_NEAR(take().out_s, 2, 1e-9);
    studio_->session().undoStack().undo();
    EXPECT_EQ(take().out_s, 0);
    EXPECT_NEAR(studio_->time().out(), studio_->time().duration(), 1e-9);
}

TEST_F(ReviewPageTest, StarsAndNotesGoIntoTheSession) {
    TakeList& takes = page_->sidebar().takes();
    takes.setCurrentIndex(takes.model()->index(0, 0));
    QTest::keyClick(&takes, Qt::Key_4);
    EXPECT_EQ(take().rating, 4);
    QPlainTextEdit& editor = page_->sidebar().notes().editor();
    editor.setPlainText("strap was loose");
    ASSERT_TRUE(waitFor([this] { return !take().notes.empty(); }));
    EXPECT_EQ(take().notes, "strap was loose");
    studio_->session().undoStack().undo();
    EXPECT_EQ(editor.toPlainText(), "");
}

TEST_F(ReviewPageTest, F2RenamesTheTakeAndTheOpenOneFollows) {
    TakeList& takes = page_->sidebar().takes();
    takes.setCurrentIndex(takes.model()->index(0, 0));
    QTest::keyClick(&takes, Qt::Key_F2);
    auto* field = takes.findChild<QLineEdit*>();
    ASSERT_TRUE(field);
    EXPECT_EQ(field->text(), "swing_001");
    QTest::keyClicks(field, "big swing");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(waitFor([this] { return take().name == "big_swing"; }));
    EXPECT_EQ(studio_->take().path(), takePath("big_swing"));
    ASSERT_TRUE(waitFor([this] {
        return studio_->take().overview()->path == studio_->take().path().toStdString() &&
               studio_->take().verdict();
    }));
    EXPECT_EQ(page_->sidebar().runs().count(), 1);
    studio_->session().undoStack().undo();
    EXPECT_EQ(take().name, "swing_001");
    EXPECT_TRUE(waitFor(
        [this] { return studio_->take().path() == takePath("swing_001") && studio_->take().verdict(); }));
}

TEST_F(ReviewPageTest, AMarkerIsListedAtTheTimeThatTheTimelineShowsThere) {
    studio_->markers().add(1.246);
    auto* list = page_->sidebar().findChild<MarkersPanel*>();
    ASSERT_TRUE(waitFor([&] { return list->item(0)->text().contains("Marker 1") && jobsAreDone(); }));
    emit list->itemClicked(list->item(0));
    const QString listed = list->item(0)->text().section(' ', 0, 0);
    EXPECT_EQ(listed, timeText(1.246, 2));
    EXPECT_TRUE(page_->center().timeline().valueText().startsWith(listed))
        << page_->center().timeline().valueText().toStdString();
}

TEST_F(ReviewPageTest, MarkersStandRightBelowTheirHeadingAndInItsColumn) {
    window_->resize(1920, 1400);  // height to spare
    const auto* list = page_->sidebar().findChild<MarkersPanel*>();
    const QWidget* section = list->parentWidget();
    ASSERT_TRUE(waitFor([this] { return page_->height() > 1300; }));
    EXPECT_EQ(section->height(), section->sizeHint().height()) << "no height to spare is between them";
    EXPECT_EQ(list->viewport()->x() + list->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1, 12);
}

TEST_F(ReviewPageTest, KeysReachThePageFromItsDocks) {
    const double before_s = studio_->time().time();
    QTest::keyClick(&page_->sidebar().takes(), Qt::Key_Right);
    EXPECT_GT(studio_->time().time(), before_s);
    QTest::keyClick(&page_->reportPanel().joints(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_GT(studio_->time().time(), before_s + 0.9);
}

TEST_F(ReviewPageTest, EveryKeyOfTheMenuActsWhereverTheFocusIs) {
    TimeCursor& time = studio_->time();
    const auto key = [this](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&page_->reportPanel(), key, modifiers);
    };
    key(Qt::Key_Space);
    EXPECT_TRUE(time.isPlaying());
    key(Qt::Key_Space);
    EXPECT_FALSE(time.isPlaying());
    time.setTime(0.5);
    key(Qt::Key_I, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(time.in(), 0.5);
    time.setTime(1.5);
    key(Qt::Key_O, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(time.out(), 1.5);
    key(Qt::Key_Home);
    EXPECT_DOUBLE_EQ(time.time(), 0.5);
    key(Qt::Key_End);
    EXPECT_DOUBLE_EQ(time.time(), 1.5);
    const bool looped = time.loops();
    key(Qt::Key_L, Qt::ControlModifier);
    EXPECT_NE(time.loops(), looped);
    key(Qt::Key_M);
    const auto markers = [this] { return studio_->take().overview()->markers.size(); };
    ASSERT_TRUE(waitFor([&] { return markers() == 1 && jobsAreDone(); }));
    time.setTime(0.7);
    key(Qt::Key_Period);
    EXPECT_NEAR(time.time(), 1.5, 1e-5);
    key(Qt::Key_Comma);
    EXPECT_NEAR(time.time(), 1.5, 1e-5) << "there is none before it";
    key(Qt::Key_Delete);
    EXPECT_TRUE(waitFor([&] { return markers() == 0 && jobsAreDone(); }));
    for (const QAction* action : page_->menuActions())
        for (const QAction* other : page_->menuActions())
            if (action != other && !action->shortcut().isEmpty()) {
                EXPECT_NE(action->shortcut(), other->shortcut()) << action->text().toStdString();
            }
}

TEST_F(ReviewPageTest, AContactSetFromTheMenuIsTheOneThingChosen) {
    Timeline& timeline = page_->center().timeline();
    studio_->markers().add(1);
    ASSERT_TRUE(waitFor([this] { return studio_->contacts().contacts() && jobsAreDone(); }));
    studio_->time().setTime(0.5);
    timeline.goToMarker(1);
    ASSERT_TRUE(timeline.canEditMarker());
    QTest::keyClick(&page_->reportPanel(), Qt::Key_Insert);
    EXPECT_TRUE(timeline.contactBars().hasChosen());
    EXPECT_FALSE(timeline.canEditMarker());
}

TEST_F(ReviewPageTest, InsertInANoteSetsNoContact) {
    ASSERT_TRUE(waitFor([this] { return studio_->contacts().contacts() != nullptr; }));
    QApplication::setActiveWindow(window_.get());
    QPlainTextEdit& notes = window_->findChild<NotesPanel*>()->editor();
    notes.setFocus();
    ASSERT_TRUE(notes.hasFocus());
    const int steps = studio_->session().undoStack().count();
    QTest::keyClick(&notes, Qt::Key_Insert);
    EXPECT_EQ(studio_->session().undoStack().count(), steps);
    EXPECT_FALSE(page_->center().timeline().contactBars().hasChosen());
}

TEST_F(ReviewPageTest, KeysHeldWithOthersAreNotThoseOfTheMenu) {
    const double before_s = studio_->time().time();
    QTest::keyClick(&page_->reportPanel(), Qt::Key_Space, Qt::ShiftModifier);
    QTest::keyClick(&page_->reportPanel(), Qt::Key_Right, Qt::AltModifier);
    EXPECT_FALSE(studio_->time().isPlaying());
    EXPECT_DOUBLE_EQ(studio_->time().time(), before_s);
}

}  // namespace
}  // namespace noctule::ui
