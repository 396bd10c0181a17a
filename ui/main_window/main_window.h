// SPDX-License-Identifier: Apache-2.0
// The one window: top bar with menus and steps, docks left and right, the page in the centre, the status
// line. It keeps one page per step, made when it is first shown, and carries commands between menus, pages
// and the session.
#pragma once

#include <QMainWindow>
#include <map>

#include "ui/main_window/notices.h"
#include "ui/main_window/window_actions.h"
#include "ui/models/session_marker.h"
#include "ui/models/studio.h"
#include "ui/views/session/recent_sessions.h"

class QStackedWidget;

namespace noctule::ui {

class HelpWindow;
class JobsPanel;
class Page;
class RecordRun;
class RobotDrive;
class SessionNotices;
class SideDocks;
class StatusLine;
class TopBar;
class WindowMenus;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(Studio& studio, QWidget* parent = nullptr);
    ~MainWindow() override;

    Step step() const { return step_; }
    /// Made when it is not there yet.
    Page& page(Step step);
    WindowActions& actions() { return *actions_; }
    TopBar& topBar() { return *top_bar_; }
    StatusLine& statusLine() { return *status_; }
    JobsPanel& jobsPanel() { return *jobs_panel_; }
    Notices& notices() { return *notices_; }
    SideDocks& sideDocks() { return *docks_; }
    RobotDrive& robot() { return *robot_; }

public slots:
    void goTo(noctule::ui::Step step);
    /// A session's folder, its session.json, or a take. A take of a session opens with its session.
    void open(const QString& path);
    /// Shows what the file was understood to be, and makes a take of it.
    void importMotion(const QString& path);
    /// Shows what was found in another maker's recording, and makes a take of it.
    void importRecording(const QStringList& paths);
    /// Opens the take's session and finishes its recording.
    void recoverTake(const QString& path);
    void showPreferences();
    void showShortcuts();
    void saveDiagnosis();
    void showTour();
    /// Once, on the first start of the program.
    void offerTour();
    void focusNextPanel(bool forward = true);
    /// Log-out, shutdown, a polite kill: nothing is asked, a take that runs is completed, then the window
    /// closes.
    void endInGoodOrder();

signals:
    /// Everything must be made anew in the other language or units.
    void wordsChanged();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildParts();
    QWidget* makeCentre();
    void addBottomLine();
    void connectActions();
    void connectSteps();
    void showRobotStep();
    void connectStudio();
    Page* makePage(Step step);
    void followScale();
    void keepFocusOnPage(QWidget* before, QWidget* now);
    void showPageActions();
    void refreshTitle();
    void restoreGeometryKept();
    void openTake(const QString& path);
    void recoverWanted(SessionMarker::Finding finding);
    void onSessionExchanged();
    void onSessionOpened();
    void onTakeOpened();
    void showSuit();
    void connectNotices();
    void onFailure(const QString& what, const QString& remedy, About about);
    void onTornTake(const QString& path, const QString& why);
    void onMessage(const QString& message, About about);
    void onWarning(const QString& message, About about);
    void forget(About about);
    bool mayClose();
    void connectSuit();
    RecordRun& recordRun();
    void recordOrStop();
    void showRecording();
    void showPlaceReset();
    bool mayStopTake();

    Studio& studio_;
    RecentSessions recent_;
    SessionMarker marker_;
    Step step_ = Step::kStart;
    std::map<Step, Page*> pages_;
    WindowActions* actions_;
    RobotDrive* robot_;
    WindowMenus* menus_;
    TopBar* top_bar_;
    SideDocks* docks_;
    Notices* notices_;
    SessionNotices* session_notices_;
    QWidget* middle_;  ///< notices and page
    QStackedWidget* stack_;
    StatusLine* status_;
    JobsPanel* jobs_panel_;
    HelpWindow* help_ = nullptr;         ///< once it was asked for
    QString folder_;                     ///< of the session that was open last
    std::map<About, QStringList> told_;  ///< topics of notices
    bool closes_after_take_ = false;     ///< everything has been asked
    bool asks_nothing_ = false;          ///< nobody may be there to answer
    QString recovery_wanted_;            ///< path of a take whose session is being opened
};

}  // namespace noctule::ui
