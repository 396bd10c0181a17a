// SPDX-License-Identifier: Apache-2.0
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QRegularExpression>
#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/jobs_panel.h"
#include "ui/main_window/licences.h"
#include "ui/main_window/side_docks.h"
#include "ui/main_window/status_line.h"
#include "ui/main_window/top_bar.h"
#include "ui/main_window/tour.h"
#include "ui/style/theme.h"
#include "ui/views/connect/body_map.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/views/length_box.h"
#include "ui/views/page.h"
#include "ui/views/performer/length_field.h"
#include "ui/views/performer/performer_measures_panel.h"
#include "ui/views/performer/performer_page.h"
#include "ui/views/session/start_page.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/step_bar.h"

namespace noctule::ui {
namespace {

class MainWindowTest : public test::StudioWindow {
protected:
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(window_.get(), key, modifiers);
        QCoreApplication::processEvents();
    }
};

TEST_F(MainWindowTest, BeginsWithTheStartPageAndNothingOpen) {
    EXPECT_EQ(window_->step(), Step::kStart);
    EXPECT_FALSE(studio_->session().isOpen());
    EXPECT_TRUE(window_->topBar().steps().isHidden());
    EXPECT_EQ(window_->statusLine().jobsText(), "No jobs running");
    EXPECT_TRUE(window_->sideDocks().left().isHidden());
    EXPECT_TRUE(window_->sideDocks().right().isHidden());
}

TEST_F(MainWindowTest, LinksOfTheStartPageStandBelowTheirCaptions) {
    const QWidget& start = window_->page(Step::kStart);
    int links = 0;
    for (const Button* button : start.findChildren<Button*>()) {
        if (button->kind() != ButtonKind::kText || !button->isVisible())
            continue;
        ++links;
        EXPECT_EQ(button->x(), 0) << button->text().toStdString();
        EXPECT_EQ(button->width(), button->sizeHint().width());
    }
    EXPECT_GE(links, 3);
}

TEST_F(MainWindowTest, OpensNoLargerThanTheScreen) {
    const auto isWithin = [this] {
        const QRect room = freeRoom(*window_), place = window_->geometry();
        EXPECT_TRUE(room.contains(place))
            << place.width() << " x " << place.height() << " in " << room.width() << " x " << room.height();
    };
    isWithin();
    window_->resize(2400, 1600);
    restart();
    isWithin();
    restart();
    isWithin();
}

TEST_F(MainWindowTest, StepsOpenByKeys) {
    const std::vector<std::pair<Qt::Key, Step>> keys{
        {Qt::Key_1, Step::kConnect}, {Qt::Key_2, Step::kCalibrate}, {Qt::Key_3, Step::kRecord},
        {Qt::Key_4, Step::kReview},  {Qt::Key_5, Step::kExport},    {Qt::Key_0, Step::kStart}};
    for (const auto& [key, step] : keys) {
        press(key, Qt::ControlModifier);
        EXPECT_EQ(window_->step(), step);
        EXPECT_EQ(window_->topBar().steps().current(), TopBar::indexOf(step));
    }
    press(Qt::Key_R, Qt::ControlModifier);
    EXPECT_EQ(window_->step(), Step::kRecord);
    press(Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(window_->step(), Step::kExport);
}

TEST_F(MainWindowTest, StepsOpenByAClickOnTheirName) {
    window_->goTo(Step::kConnect);
    StepBar& steps = window_->topBar().steps();
    ASSERT_TRUE(waitFor([&] { return steps.width() >= steps.sizeHint().width(); }));
    QTest::mouseClick(steps.childAt(steps.stepRect(2).center()), Qt::LeftButton);
    EXPECT_EQ(window_->step(), Step::kRecord);
}

TEST_F(MainWindowTest, DocksNeverCutTheirContent) {
    openSampleTake();
    window_->resize(1280, 800);
    for (const Step step : {Step::kConnect, Step::kCalibrate, Step::kRecord, Step::kReview, Step::kExport,
                            Step::kPerformer, Step::kRobot}) {
        window_->goTo(step);
        ASSERT_TRUE(waitFor([&] { return window_->page(step).isVisible(); }));
        QCoreApplication::processEvents();
        for (QDockWidget* dock : {&window_->sideDocks().left(), &window_->sideDocks().right()})
            for (const ScrollArea* area : dock->findChildren<ScrollArea*>())
                EXPECT_TRUE(!area->isVisible() || area->widget()->width() <= area->viewport()->width())
                    << dock->windowTitle().toStdString() << ": " << area->widget()->width() << " in "
                    << area->viewport()->width();
    }
}

TEST_F(MainWindowTest, OpenGivesUpItsKeyInReview) {
    QAction* open = window_->actions()[Command::kOpenSession];
    EXPECT_TRUE(open->shortcuts().contains(QKeySequence("Ctrl+O")));
    window_->goTo(Step::kReview);
    EXPECT_FALSE(open->shortcuts().contains(QKeySequence("Ctrl+O")));
    EXPECT_TRUE(open->shortcuts().contains(QKeySequence("Ctrl+Shift+O")));
}

TEST_F(MainWindowTest, NoKeyStandsForTwoCommandsAtOnce) {
    for (const Step step : test::kEveryStep) {
        window_->goTo(step);
        std::map<QString, QString> owners;
        QList<QAction*> actions = window_->actions().all();
        actions.append(window_->page(step).menuActions());
        for (const QAction* action : actions)
            for (const QKeySequence& key : action->shortcuts()) {
                const auto [owner, is_new] = owners.emplace(key.toString(), action->text());
                EXPECT_TRUE(is_new) << key.toString().toStdString() << " in step " << static_cast<int>(step)
                                    << ": " << owner->second.toStdString() << " and "
                                    << action->text().toStdString();
            }
    }
}

TEST_F(MainWindowTest, JobsPanelOpensAndClosesByKeys) {
    press(Qt::Key_J, Qt::ControlModifier);
    EXPECT_TRUE(window_->jobsPanel().isVisible());
    QTest::keyClick(&window_->jobsPanel(), Qt::Key_Escape);
    EXPECT_FALSE(window_->jobsPanel().isVisible());
}

TEST_F(MainWindowTest, FinishedJobsStayUntilTheyWereSeen) {
    Job* job = studio_->jobs().start<int>(
        "Counting", [](const JobContext&) -> Result<int> { return 3; },
        [](Result<int> value) { return QString("Counted to %1").arg(*value); });
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kDone; }));
    EXPECT_EQ(window_->statusLine().jobsText(), "1 job finished");
    window_->jobsPanel().toggle();
    EXPECT_EQ(window_->jobsPanel().rowCount(), 1);
    EXPECT_FALSE(job->seen());
    window_->jobsPanel().toggle();
    EXPECT_TRUE(job->seen());
    EXPECT_EQ(window_->statusLine().jobsText(), "No jobs running");
}

TEST_F(MainWindowTest, AFailedJobSaysSoInWords) {
    Job* job = studio_->jobs().start<int>(
        "Writing",
        [](const JobContext&) -> Result<int> {
            return Error{ErrorKind::kDisk, "The disk is full", "Free some"};
        },
        [](Result<int>) { return QString(); });
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kFailed; }));
    EXPECT_EQ(window_->statusLine().jobsText(), "1 job failed");
}

/// Answers the question that closing asks, and tells what it said.
QString answerClosing(MainWindow& window, const QString& answer) {
    QString said;
    QTimer::singleShot(100, &window, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return;
        said = box->text() + '\n' + box->informativeText();
        for (QAbstractButton* button : box->buttons())
            if (button->text() == answer)
                button->click();
    });
    window.close();
    return said;
}

TEST_F(MainWindowTest, ClosingNamesRunningJobsAndAsks) {
    Job* job = studio_->jobs().start<int>(
        "Processing walk_001",
        [](const JobContext& context) -> Result<int> {
            while (!context.cancelled())
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            return JobContext::cancelledError();
        },
        [](Result<int>) { return QString(); });
    EXPECT_TRUE(answerClosing(*window_, "Go on working").contains("Processing walk_001"));
    EXPECT_TRUE(window_->isVisible());
    EXPECT_EQ(job->state(), Job::State::kRunning);
    answerClosing(*window_, "Cancel jobs and close");
    EXPECT_FALSE(window_->isVisible());
    EXPECT_TRUE(waitFor([&] { return job->state() == Job::State::kCancelled; }));
}

TEST_F(MainWindowTest, CtrlZTakesBackWhatWasTypedAFieldBefore) {
    ASSERT_TRUE(studio_->session().create(home() + "-typed", "typed"));
    window_->goTo(Step::kPerformer);
    window_->activateWindow();
    PerformerMeasuresPanel& measures =
        dynamic_cast<PerformerPage&>(window_->page(Step::kPerformer)).measures();
    const auto height_m = [this] { return studio_->session().session().performers.at(0).measures.height_m; };
    const double before_m = height_m();
    measures.height().setFocus();
    ASSERT_TRUE(waitFor([&] { return measures.height().hasFocus(); }));
    measures.height().selectAll();
    QTest::keyClicks(&measures.height(), "190");
    QLineEdit* next = measures.field(&BodyMeasures::forearm_m).edit();
    next->setFocus();
    ASSERT_EQ(window_->focusWidget(), next);
    ASSERT_DOUBLE_EQ(height_m(), 1.9);
    QTest::keyClick(next, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(height_m(), before_m);
}

TEST_F(MainWindowTest, F6WalksThePanels) {
    window_->goTo(Step::kConnect);
    const auto panelOfFocus = [this]() -> QWidget* {
        for (QWidget* panel :
             {static_cast<QWidget*>(&window_->topBar()), static_cast<QWidget*>(&window_->sideDocks().left()),
              window_->centralWidget(), static_cast<QWidget*>(&window_->sideDocks().right()),
              static_cast<QWidget*>(&window_->statusLine())})
            if (panel->isAncestorOf(QApplication::focusWidget()))
                return panel;
        return nullptr;
    };
    std::vector<QWidget*> visited;
    for (int i = 0; i < 5; ++i) {
        press(Qt::Key_F6);
        visited.push_back(panelOfFocus());
    }
    EXPECT_EQ(std::set<QWidget*>(visited.begin(), visited.end()).size(), 5U);
    EXPECT_FALSE(std::count(visited.begin(), visited.end(), nullptr));
    press(Qt::Key_F6, Qt::ShiftModifier);
    EXPECT_EQ(panelOfFocus(), visited[3]);
}

TEST_F(MainWindowTest, WhereAButtonGoesThatWasPressedTheFocusStaysOnThePage) {
    press(Qt::Key_3, Qt::ControlModifier);
    Page& record = window_->page(Step::kRecord);
    QPushButton button("Process", &record);  // the last of the window: the next one is the first
    button.show();
    window_->activateWindow();
    button.setFocus();
    ASSERT_EQ(window_->focusWidget(), &button);
    button.hide();
    EXPECT_EQ(window_->focusWidget(), &record);
}

TEST_F(MainWindowTest, TheTourIsWalkedByKeysAndLeadsBack) {
    press(Qt::Key_5, Qt::ControlModifier);
    window_->activateWindow();
    window_->showTour();
    auto* tour = window_->findChild<Tour*>();
    ASSERT_NE(tour, nullptr);
    const auto key = [&](Qt::Key which) {
        QTest::keyClick(window_->focusWidget(), which);
        QCoreApplication::processEvents();
    };
    key(Qt::Key_Return);
    key(Qt::Key_Space);
    EXPECT_EQ(tour->card(), 2);
    EXPECT_EQ(window_->step(), Step::kRecord);
    for (int tab = 0; tab < 4; ++tab) {
        key(Qt::Key_Tab);
        EXPECT_TRUE(tour->isAncestorOf(window_->focusWidget())) << tab;
    }
    key(Qt::Key_Escape);
    EXPECT_FALSE(tour->isVisible());
    EXPECT_EQ(window_->step(), Step::kExport) << "where it was begun";
}

TEST_F(MainWindowTest, InASmallWindowTheLeftDockGivesRoomAndComesBack) {
    press(Qt::Key_4, Qt::ControlModifier);
    SideDocks& docks = window_->sideDocks();
    const auto resized = [&](int width) {
        window_->resize(width, 700);
        for (int turn = 0; turn < 4; ++turn)
            QCoreApplication::processEvents();
    };
    resized(1440);
    EXPECT_FALSE(docks.left().isHidden());
    const int usual = docks.right().width();
    resized(1024);
    EXPECT_TRUE(docks.left().isHidden());
    EXPECT_FALSE(docks.right().isHidden());
    docks.left().toggleViewAction()->trigger();
    EXPECT_FALSE(docks.left().isHidden());
    EXPECT_TRUE(docks.right().isHidden()) << "the operator wants the other one";
    docks.right().toggleViewAction()->trigger();
    resized(1440);
    EXPECT_FALSE(docks.left().isHidden()) << "whichever went for the other one comes back";
    EXPECT_FALSE(docks.right().isHidden());
    resized(1024);
    EXPECT_TRUE(docks.left().isHidden());
    press(Qt::Key_3, Qt::ControlModifier);
    press(Qt::Key_4, Qt::ControlModifier);
    resized(1440);
    EXPECT_FALSE(docks.left().isHidden()) << "also after another step was shown";

    Theme::get().setScale(1.5);
    resized(1440);
    EXPECT_TRUE(docks.left().isHidden());
    Theme::get().setScale(1);
    resized(1440);
    EXPECT_FALSE(docks.left().isHidden());
    EXPECT_NEAR(docks.right().width(), usual, 40) << "as wide as before the type was large";
}

TEST_F(MainWindowTest, LayoutsAreKeptPerStepAndSurviveARestart) {
    window_->goTo(Step::kRecord);
    window_->goTo(Step::kConnect);
    window_->sideDocks().right().close();
    window_->goTo(Step::kRecord);
    EXPECT_TRUE(window_->sideDocks().right().isVisible());
    window_->goTo(Step::kConnect);
    EXPECT_FALSE(window_->sideDocks().right().isVisible());

    restart();
    window_->goTo(Step::kRecord);
    EXPECT_TRUE(window_->sideDocks().right().isVisible());
    window_->goTo(Step::kConnect);
    EXPECT_FALSE(window_->sideDocks().right().isVisible());
    window_->actions()[Command::kResetLayout]->trigger();
    EXPECT_TRUE(window_->sideDocks().right().isVisible());
}

TEST_F(MainWindowTest, MenusFoldIntoOneButtonWhereThereIsNoRoom) {
    window_->goTo(Step::kConnect);
    window_->resize(1300, 800);
    EXPECT_TRUE(waitFor([this] { return !window_->topBar().isFolded(); }));
    window_->resize(1100, 800);
    EXPECT_TRUE(waitFor([this] { return window_->topBar().isFolded(); }));
}

TEST_F(MainWindowTest, FitsTheSmallestScreen) {
    for (const Step step :
         {Step::kStart, Step::kConnect, Step::kCalibrate, Step::kRecord, Step::kReview, Step::kExport}) {
        window_->goTo(step);
        window_->resize(1280, 800);
        QCoreApplication::processEvents();
        EXPECT_LE(window_->width(), 1280) << "step " << static_cast<int>(step);
        EXPECT_LE(window_->height(), 800) << "step " << static_cast<int>(step);
    }
}

TEST_F(MainWindowTest, WordsPointToNoDockThatIsAway) {
    Theme::get().setScale(1.5);
    window_->resize(1280, 800);
    const QRegularExpression side("\\b(at|on) the (left|right)\\b");
    for (const Step step : {Step::kConnect, Step::kCalibrate, Step::kRecord, Step::kRobot}) {
        window_->goTo(step);
        ASSERT_TRUE(waitFor([&] { return window_->sideDocks().left().isHidden(); }));
        for (const QWidget* widget : window_->page(step).findChildren<QWidget*>()) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            const QString words = widget->toolTip() + ' ' + (label ? label->text() : QString());
            EXPECT_FALSE(words.contains(side)) << words.toStdString();
        }
    }
    auto& connect = dynamic_cast<ConnectPage&>(window_->page(Step::kConnect));
    const QString verdict = connect.readiness().verdictText();
    EXPECT_FALSE(verdict.isEmpty());
    EXPECT_FALSE(verdict.contains(side)) << verdict.toStdString();
    Theme::get().setScale(1);
}

TEST_F(MainWindowTest, AFailureIsToldOnceAboveThePage) {
    emit studio_->failed("The take could not be processed", "Free some room", About::kProcess);
    emit studio_->failed("The take could not be processed", "Free some room", About::kProcess);
    EXPECT_EQ(window_->notices().titles(), QStringList{"The take could not be processed"});
    EXPECT_TRUE(window_->notices().isVisible());
}

TEST_F(MainWindowTest, TheBodyComesIntoTheDrawingWhenItIsLoaded) {
    Studio studio(studio_->parts());
    EXPECT_FALSE(studio.body()) << "the interface does not wait for it";
    ConnectPage page(studio);
    page.resize(900, 700);
    page.show();
    page.enter();
    const auto drawing = [&] { return page.findChild<BodyMap*>()->grab().toImage(); };
    const QImage without = drawing();
    int calls = 0;
    studio.whenBodyIsThere(&page, [&calls] { ++calls; });
    EXPECT_EQ(calls, 0);
    ASSERT_TRUE(waitFor([&] { return calls == 1; }));
    EXPECT_TRUE(studio.body());
    EXPECT_NE(drawing(), without);
    studio.whenBodyIsThere(&page, [&calls] { ++calls; });
    EXPECT_EQ(calls, 2) << "at once";
}

TEST_F(MainWindowTest, AboutNamesTheVersionOfEveryLibrary) {
    const QRegularExpression version("^\\d+\\.\\d+");
    for (const LinkedWork& work : linkedWorks())
        if (work.what_for != "typeface") {
            EXPECT_TRUE(version.match(work.version).hasMatch())
                << work.name.toStdString() << " " << work.version.toStdString();
        }
    EXPECT_TRUE(licencesAsText("noctule 0.1.0").contains("SQLite 3."));
}

TEST_F(MainWindowTest, APathThatIsNotThereIsToldByName) {
    window_->open("/nowhere/session");
    ASSERT_EQ(window_->notices().count(), 1);
    EXPECT_TRUE(window_->notices().titles().first().contains("/nowhere/session"));
    window_->open(folder_.path());
    EXPECT_TRUE(window_->notices().titles().first().contains("holds no session"));
}

}  // namespace
}  // namespace noctule::ui
