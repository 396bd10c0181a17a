// SPDX-License-Identifier: Apache-2.0
// Commands of menus, keys and pages, and what they do.
#include <QDate>
#include <QFileInfo>

#include "core/job/atomic_file.h"
#include "ui/language/core_words.h"
#include "ui/main_window/about_dialog.h"
#include "ui/main_window/diagnosis.h"
#include "ui/main_window/help_window.h"
#include "ui/main_window/jobs_panel.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/news_dialog.h"
#include "ui/main_window/pages.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/put_on_dialog.h"
#include "ui/main_window/shortcuts_dialog.h"
#include "ui/main_window/side_docks.h"
#include "ui/main_window/status_line.h"
#include "ui/main_window/top_bar.h"
#include "ui/main_window/tour.h"
#include "ui/main_window/window_menus.h"
#include "ui/models/file_choice.h"
#include "ui/robot/robot_drive.h"
#include "ui/robot/robot_page.h"
#include "ui/style/theme.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/performer/body_dialog.h"
#include "ui/views/session/motion_dialog.h"
#include "ui/views/session/recording_dialog.h"
#include "ui/views/session/session_commands.h"
#include "ui/views/session/start_page.h"
#include "ui/views/show_folder.h"
#include "ui/wizards/calibrate_page.h"

namespace noctule::ui {
void MainWindow::connectActions() {
    const auto on = [this](Command command, auto&& act) {
        connect((*actions_)[command], &QAction::triggered, this, std::forward<decltype(act)>(act));
    };
    on(Command::kNewSession, [this] { SessionCommands::askForNew(this, studio_); });
    on(Command::kOpenSession, [this] { SessionCommands::askToOpen(this, studio_); });
    on(Command::kOpenTake, [this] {
        const QStringList takes = SessionCommands::askForTakes(this, studio_);
        if (!takes.isEmpty())
            open(takes.first());
    });
    on(Command::kImportTakes, [this] { SessionCommands::askForImport(this, studio_); });
    on(Command::kImportMotion, [this] {
        if (const QString path = SessionCommands::askForMotion(this); !path.isEmpty())
            importMotion(path);
    });
    on(Command::kImportRecording, [this] {
        if (const QStringList paths = SessionCommands::askForRecording(this); !paths.isEmpty())
            importRecording(paths);
    });
    on(Command::kShowFolder,
       [this] { showFolder(studio_, QString::fromStdString(studio_.session().session().folder.string())); });
    on(Command::kCloseSession, [this] { studio_.session().close(); });
    on(Command::kExport, [this] { goTo(Step::kExport); });
    on(Command::kQuit, [this] { close(); });
    on(Command::kPreferences, [this] { showPreferences(); });
    on(Command::kRecord, [this] { recordOrStop(); });
    on(Command::kPerformer, [this] { goTo(Step::kPerformer); });
    on(Command::kPutSuitOn, [this] { PutOnDialog(studio_, this).exec(); });
    on(Command::kResetPlace, [this] { studio_.placeReset().reset(); });
    on(Command::kResetPlaceLater, [this] { studio_.placeReset().resetLater(); });
    on(Command::kBody, [this] { BodyDialog(studio_, this).exec(); });
    on(Command::kJobs, [this] { jobs_panel_->toggle(); });
    on(Command::kNextPanel, [this] { focusNextPanel(true); });
    on(Command::kPreviousPanel, [this] { focusNextPanel(false); });
    on(Command::kFullScreen,
       [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
    on(Command::kResetLayout, [this] { docks_->reset(); });
    on(Command::kShortcuts, [this] { showShortcuts(); });
    on(Command::kTour, [this] { showTour(); });
    on(Command::kNews, [this] { NewsDialog(this).exec(); });
    on(Command::kDocuments, [this] {
        if (!help_)
            help_ = new HelpWindow(this);
        help_->showDocument("guide");
    });
    on(Command::kSaveDiagnosis, [this] { saveDiagnosis(); });
    on(Command::kAbout, [this] { AboutDialog(studio_.parts().software, this).exec(); });
}

void MainWindow::saveDiagnosis() {
    const QString name = "noctule-diagnosis-" + QDate::currentDate().toString(Qt::ISODate) + ".txt";
    const QString path =
        FileChoice{"diagnoses", tr("Save diagnosis"), tr("Text files (*.txt)"), name}.toSave(this);
    if (path.isEmpty())
        return;
    const LogFile nowhere{QString()};
    const LogFile& log = studio_.parts().log ? *studio_.parts().log : nowhere;
    const QByteArray text = diagnosisText(studio_, log).toUtf8();
    if (const Status saved = writeFileAtomically(path.toStdString(), text.toStdString(), true); !saved)
        return onFailure(coreWords(saved.error().message), coreWords(saved.error().remedy), About::kFile);
    studio_.sayOfFile(tr("%1 is written. It holds no names and no folders; read it before you pass it on.")
                          .arg(QFileInfo(path).fileName()));
}

void MainWindow::connectSteps() {
    const auto to = [this](Command command, Step step) {
        connect((*actions_)[command], &QAction::triggered, this, [this, step] { goTo(step); });
    };
    to(Command::kStepStart, Step::kStart);
    to(Command::kStepConnect, Step::kConnect);
    to(Command::kStepCalibrate, Step::kCalibrate);
    to(Command::kStepRecord, Step::kRecord);
    to(Command::kStepReview, Step::kReview);
    to(Command::kStepExport, Step::kExport);
    to(Command::kStepRobot, Step::kRobot);
    connect(robot_, &RobotDrive::robotChanged, this, &MainWindow::showRobotStep);
    showRobotStep();
    connect(&studio_, &Studio::stepRequested, this, &MainWindow::goTo);
    connect(&studio_, &Studio::checkRequested, this, [this] {
        goTo(Step::kCalibrate);
        qobject_cast<CalibratePage*>(&page(Step::kCalibrate))->checkBeforeTake();
    });
    connect(top_bar_, &TopBar::stepRequested, this, &MainWindow::goTo);
    connect(top_bar_, &TopBar::recordRequested, this, [this] { goTo(Step::kRecord); });
    connect(top_bar_, &TopBar::preferencesRequested, this, &MainWindow::showPreferences);
    connect(status_, &StatusLine::jobsRequested, jobs_panel_, &JobsPanel::toggle);
    connect(jobs_panel_, &JobsPanel::closed, status_, &StatusLine::showJobs);
    connect(status_, &StatusLine::shortcutsRequested, this, &MainWindow::showShortcuts);
    connect(menus_, &WindowMenus::recentRequested, this, &MainWindow::open);
    connect(&Theme::get(), &Theme::changed, this, &MainWindow::followScale);
}

void MainWindow::showRobotStep() {
    top_bar_->showRobot(robot_->hasRobot());
    actions_->setRobotShown(robot_->hasRobot());
}

Page* MainWindow::makePage(Step step) {
    Page* page = makePageFor(step, studio_, recent_, *robot_);
    if (auto* start = qobject_cast<StartPage*>(page)) {
        connect(start, &StartPage::newSessionRequested, (*actions_)[Command::kNewSession], &QAction::trigger);
        connect(start, &StartPage::openSessionRequested, (*actions_)[Command::kOpenSession],
                &QAction::trigger);
        connect(start, &StartPage::importMotionRequested, (*actions_)[Command::kImportMotion],
                &QAction::trigger);
        connect(start, &StartPage::openRequested, this, &MainWindow::open);
        connect(start, &StartPage::recoverRequested, this, &MainWindow::recoverTake);
        connect(start, &StartPage::rebuildRequested, &studio_.session(), &SessionModel::rebuild);
        connect(start, &StartPage::tourRequested, this, &MainWindow::showTour);
        connect(start, &StartPage::putSuitOnRequested, (*actions_)[Command::kPutSuitOn], &QAction::trigger);
        connect(start, &StartPage::newsRequested, (*actions_)[Command::kNews], &QAction::trigger);
    }
    if (auto* robot = qobject_cast<RobotPage*>(page))
        connect(robot, &RobotPage::suitRecordingWanted, this, &MainWindow::recordOrStop);
    if (auto* connecting = qobject_cast<ConnectPage*>(page))
        connect(connecting, &ConnectPage::putSuitOnRequested, (*actions_)[Command::kPutSuitOn],
                &QAction::trigger);
    return page;
}

void MainWindow::importMotion(const QString& path) {
    MotionDialog(studio_, path, this).exec();
}

void MainWindow::importRecording(const QStringList& paths) {
    RecordingDialog(studio_, paths, this).exec();
}

void MainWindow::showPreferences() {
    bool words_changed = false;
    {
        PreferencesDialog dialog(studio_, this);
        const auto calibrate = pages_.find(Step::kCalibrate);
        dialog.setCalibrating(calibrate != pages_.end() &&
                              dynamic_cast<CalibratePage&>(*calibrate->second).isUnderWay());
        connect(&dialog, &PreferencesDialog::wordsChanged, this, [&] { words_changed = true; });
        dialog.exec();
    }
    if (words_changed)
        emit wordsChanged();  // this window may be gone afterwards
}

void MainWindow::offerTour() {
    if (Tour::isDue(studio_.settings()))
        notices_->add(
            {Tone::kNeutral,
             tr("New to Noctule?"),
             tr("A tour of the five steps takes two minutes. It can be left at any time, and it is always "
                "under Help."),
             tr("Start the tour"),
             [this] { showTour(); },
             {},
             [this] { Tour::noteAnswer(studio_.settings()); }});
}

void MainWindow::showShortcuts() {
    // All commands, so that a key is not given to two: pages are made when they are first shown.
    for (const Step step : {Step::kConnect, Step::kCalibrate, Step::kRecord, Step::kReview, Step::kExport,
                            Step::kPerformer, Step::kRobot})
        page(step);
    QList<ShortcutGroup> groups{{tr("Anywhere"), actions_->all()}};
    for (const auto& [step, page] : pages_)
        if (!page->menuActions().isEmpty())
            groups.append({page->title(), page->menuActions()});
    ShortcutsDialog(groups, this).exec();
}

void MainWindow::showTour() {
    Tour::noteAnswer(studio_.settings());
    auto* tour = new Tour(*this, *top_bar_);
    tour->start();
}

}  // namespace noctule::ui
