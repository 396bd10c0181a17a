// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/window_actions.h"

#include "ui/style/keys.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// In settings; a name stays the same in every version.
const std::map<Command, const char*>& namesOfCommands() {
    static const std::map<Command, const char*> kNames{
        {Command::kNewSession, "window/new_session"},
        {Command::kOpenSession, "window/open_session"},
        {Command::kOpenTake, "window/open_take"},
        {Command::kImportTakes, "window/import_takes"},
        {Command::kImportMotion, "window/import_motion"},
        {Command::kImportRecording, "window/import_recording"},
        {Command::kShowFolder, "window/show_folder"},
        {Command::kCloseSession, "window/close_session"},
        {Command::kExport, "window/export"},
        {Command::kQuit, "window/quit"},
        {Command::kUndo, "window/undo"},
        {Command::kRedo, "window/redo"},
        {Command::kPreferences, "window/preferences"},
        {Command::kStepStart, "window/step_start"},
        {Command::kStepConnect, "window/step_connect"},
        {Command::kStepCalibrate, "window/step_calibrate"},
        {Command::kStepRecord, "window/step_record"},
        {Command::kStepReview, "window/step_review"},
        {Command::kStepExport, "window/step_export"},
        {Command::kStepRobot, "window/step_robot"},
        {Command::kJobs, "window/jobs"},
        {Command::kNextPanel, "window/next_panel"},
        {Command::kPreviousPanel, "window/previous_panel"},
        {Command::kFullScreen, "window/full_screen"},
        {Command::kResetLayout, "window/reset_layout"},
        {Command::kRecord, "window/record"},
        {Command::kBody, "window/body"},
        {Command::kPerformer, "window/performer"},
        {Command::kPutSuitOn, "window/put_suit_on"},
        {Command::kResetPlace, "window/reset_place"},
        {Command::kResetPlaceLater, "window/reset_place_later"},
        {Command::kShortcuts, "window/shortcuts"},
        {Command::kTour, "window/tour"},
        {Command::kNews, "window/news"},
        {Command::kDocuments, "window/documents"},
        {Command::kSaveDiagnosis, "window/save_diagnosis"},
        {Command::kAbout, "window/about"},
    };
    return kNames;
}

}  // namespace

WindowActions::WindowActions(QWidget& window) : QObject(&window), window_(window) {
    addFileActions();
    addStepActions();
    addViewActions();
    addSuitAndHelpActions();
    refreshIcons();
    connect(&Theme::get(), &Theme::changed, this, &WindowActions::refreshIcons);
}

void WindowActions::addFileActions() {
    add(Command::kNewSession, tr("New session"), {QKeySequence("Ctrl+N")}, "new");
    add(Command::kOpenSession, tr("Open session"), {QKeySequence("Ctrl+O"), QKeySequence("Ctrl+Shift+O")},
        "open");
    add(Command::kOpenTake, tr("Open take"), {}, "");
    add(Command::kImportTakes, tr("Import takes into this session"), {}, "");
    add(Command::kImportMotion, tr("Import motion"), {QKeySequence("Ctrl+Shift+M")}, "skeleton");
    add(Command::kImportRecording, tr("Import recording"), {QKeySequence("Ctrl+Shift+R")}, "board");
    add(Command::kShowFolder, tr("Show session folder"), {}, "folder");
    add(Command::kCloseSession, tr("Close session"), {}, "");
    add(Command::kExport, tr("Export"), {QKeySequence("Ctrl+E")}, "export");
    add(Command::kQuit, tr("Quit"), {QKeySequence("Ctrl+Q")}, "")->setMenuRole(QAction::QuitRole);
    add(Command::kPreferences, tr("Preferences"), {QKeySequence("Ctrl+,")}, "gear")
        ->setMenuRole(QAction::PreferencesRole);
}

void WindowActions::addStepActions() {
    add(Command::kStepStart, tr("Start page"), {QKeySequence("Ctrl+0")}, "");
    add(Command::kStepConnect, tr("Connect"), {QKeySequence("Ctrl+1")}, "");
    add(Command::kStepCalibrate, tr("Calibrate"), {QKeySequence("Ctrl+2")}, "");
    add(Command::kStepRecord, tr("Record"), {QKeySequence("Ctrl+3")}, "");
    add(Command::kStepReview, tr("Review"), {QKeySequence("Ctrl+4")}, "");
    add(Command::kStepExport, tr("Export"), {QKeySequence("Ctrl+5")}, "");
    add(Command::kStepRobot, tr("Robot"), {}, "");
    for (const Command step :
         {Command::kStepStart, Command::kStepConnect, Command::kStepCalibrate, Command::kStepRecord,
          Command::kStepReview, Command::kStepExport, Command::kStepRobot})
        actions_.at(step)->setCheckable(true);
}

void WindowActions::addViewActions() {
    add(Command::kBody, tr("Body of the view"), {}, "mesh");
    add(Command::kJobs, tr("Jobs"), {QKeySequence("Ctrl+J")}, "");
    add(Command::kNextPanel, tr("Next panel"), {QKeySequence("F6")}, "");
    add(Command::kPreviousPanel, tr("Previous panel"), {QKeySequence("Shift+F6")}, "");
    add(Command::kFullScreen, tr("Full screen"), {QKeySequence("F11")}, "")->setCheckable(true);
    add(Command::kResetLayout, tr("Reset this layout"), {}, "");
}

void WindowActions::addSuitAndHelpActions() {
    add(Command::kRecord, tr("Record or stop"), {QKeySequence("Ctrl+R")}, "");
    add(Command::kPerformer, tr("Performer and suit"), {}, "mesh");
    add(Command::kPutSuitOn, tr("Put the suit on"), {}, "note");
    add(Command::kResetPlace, tr("Reset heading and place"), {QKeySequence("Ctrl+H")}, "here");
    add(Command::kResetPlaceLater, tr("Reset heading and place after the countdown"),
        {QKeySequence("Ctrl+Shift+H")}, "");
    for (const Command command : {Command::kResetPlace, Command::kResetPlaceLater})
        actions_.at(command)->setAutoRepeat(false);
    add(Command::kShortcuts, tr("Shortcuts"), {QKeySequence("F1")}, "");
    add(Command::kTour, tr("Tour of the five steps"), {}, "info");
    add(Command::kNews, tr("What is new"), {}, "history");
    add(Command::kDocuments, tr("Guide and documents"), {QKeySequence("Shift+F1")}, "");
    add(Command::kSaveDiagnosis, tr("Save diagnosis"), {}, "");
    add(Command::kAbout, tr("About Noctule"), {}, "")->setMenuRole(QAction::AboutRole);
}

QAction* WindowActions::add(Command command, const QString& text, const QList<QKeySequence>& keys,
                            const char* icon) {
    auto* action = new QAction(text, &window_);
    if (*icon)
        icons_[action] = icon;
    adopt(command, action, keys);
    return action;
}

void WindowActions::adopt(Command command, QAction* action, const QList<QKeySequence>& keys) {
    actions_[command] = action;
    Keys::get().adopt(*action, namesOfCommands().at(command), keys);
    window_.addAction(action);
}

void WindowActions::setReviewShown(bool shown) {
    Keys::get().restrict(*actions_.at(Command::kOpenSession), [shown](const QKeySequence& key) {
        return !shown || key != Keys::keyOf("review/out", QKeySequence("Ctrl+O"));
    });
}

void WindowActions::setRobotShown(bool shown) {
    Keys& keys = Keys::get();
    keys.restrict(*actions_.at(Command::kStepRobot), [shown](const QKeySequence&) { return shown; });
    keys.setUsual(*actions_.at(Command::kStepRobot),
                  shown ? QList<QKeySequence>{QKeySequence("Ctrl+4")} : QList<QKeySequence>{});
    keys.setUsual(*actions_.at(Command::kStepReview), {QKeySequence(shown ? "Ctrl+5" : "Ctrl+4")});
    keys.setUsual(*actions_.at(Command::kStepExport), {QKeySequence(shown ? "Ctrl+6" : "Ctrl+5")});
}

QList<QAction*> WindowActions::all() const {
    QList<QAction*> actions;
    for (const auto& [command, action] : actions_)
        actions.append(action);
    return actions;
}

void WindowActions::refreshIcons() {
    for (const auto& [action, name] : icons_)
        action->setIcon(Theme::get().icon(name));
}

}  // namespace noctule::ui
