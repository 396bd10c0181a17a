// SPDX-License-Identifier: Apache-2.0
// Every command of the main window as one QAction: menus, top bar, keys and the list of shortcuts are made
// from here. Pages bring actions of their own (ui/views/page.h).
#pragma once

#include <QAction>
#include <QWidget>
#include <map>

namespace noctule::ui {

enum class Command {
    kNewSession,
    kOpenSession,
    kOpenTake,
    kImportTakes,
    kImportMotion,
    kImportRecording,
    kShowFolder,
    kCloseSession,
    kExport,
    kQuit,
    kUndo,
    kRedo,
    kPreferences,
    kStepStart,
    kStepConnect,
    kStepCalibrate,
    kStepRecord,
    kStepReview,
    kStepExport,
    kStepRobot,
    kJobs,
    kNextPanel,
    kPreviousPanel,
    kFullScreen,
    kResetLayout,
    kRecord,
    kBody,
    kPerformer,
    kPutSuitOn,
    kResetPlace,
    kResetPlaceLater,
    kShortcuts,
    kTour,
    kNews,
    kDocuments,
    kSaveDiagnosis,
    kAbout,
};

class WindowActions : public QObject {
    Q_OBJECT
public:
    /// The actions belong to the window, so that their keys work also while the menus are folded away.
    explicit WindowActions(QWidget& window);

    QAction* operator[](Command command) const { return actions_.at(command); }
    /// Undo and redo come from the undo stack, which words them.
    void adopt(Command command, QAction* action, const QList<QKeySequence>& keys);
    /// In Review the key of the out point is its own: Ctrl+O, unless the operator gave it another one.
    void setReviewShown(bool shown);
    /// The keys of steps are their numbers: with a robot, its step stands before Review. Without one no key
    /// leads to it.
    void setRobotShown(bool shown);
    /// In the order of Command, for the list of shortcuts.
    QList<QAction*> all() const;

private:
    QAction* add(Command command, const QString& text, const QList<QKeySequence>& keys, const char* icon);
    void addFileActions();
    void addStepActions();
    void addViewActions();
    void addSuitAndHelpActions();
    void refreshIcons();

    QWidget& window_;
    std::map<Command, QAction*> actions_;
    std::map<QAction*, QString> icons_;
};

}  // namespace noctule::ui
