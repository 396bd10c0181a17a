// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/window_menus.h"

#include <QActionGroup>
#include <QFileInfo>

#include "ui/style/theme.h"

namespace noctule::ui {

WindowMenus::WindowMenus(WindowActions& actions, RecentSessions& recent, QMenuBar& bar)
    : QObject(&bar),
      actions_(actions),
      recent_(recent),
      file_(bar.addMenu(tr("&File"))),
      edit_(bar.addMenu(tr("&Edit"))),
      view_(bar.addMenu(tr("&View"))),
      suit_(bar.addMenu(tr("&Suit"))),
      take_(bar.addMenu(tr("&Take"))),
      help_(bar.addMenu(tr("&Help"))) {
    buildFile();
    edit_->addActions({actions_[Command::kUndo], actions_[Command::kRedo]});
    edit_->addSeparator();
    edit_->addAction(actions_[Command::kPreferences]);
    buildView();
    buildSuitAndHelp();
    showPageActions(Step::kStart, {});
}

void WindowMenus::buildFile() {
    file_->addActions({actions_[Command::kNewSession], actions_[Command::kOpenSession]});
    recent_menu_ = file_->addMenu(tr("Recent sessions"));
    connect(recent_menu_, &QMenu::aboutToShow, this, &WindowMenus::fillRecent);
    file_->addAction(actions_[Command::kOpenTake]);
    file_->addSeparator();
    file_->addActions({actions_[Command::kImportTakes], actions_[Command::kImportMotion],
                       actions_[Command::kImportRecording], actions_[Command::kExport],
                       actions_[Command::kShowFolder]});
    file_->addSeparator();
    file_->addActions({actions_[Command::kCloseSession], actions_[Command::kQuit]});
}

void WindowMenus::fillRecent() {
    recent_menu_->clear();
    for (const RecentSession& session : recent_.all()) {
        QAction* action = recent_menu_->addAction(QString(session.name).replace('&', "&&"));
        action->setToolTip(session.folder);
        connect(action, &QAction::triggered, this,
                [this, folder = session.folder] { emit recentRequested(folder); });
    }
    if (recent_menu_->isEmpty())
        recent_menu_->addAction(tr("No session was open before"))->setEnabled(false);
}

void WindowMenus::buildView() {
    const auto step = [this](Command command) { return actions_[command]; };
    auto* steps = new QActionGroup(this);
    for (const Command command :
         {Command::kStepStart, Command::kStepConnect, Command::kStepCalibrate, Command::kStepRecord,
          Command::kStepRobot, Command::kStepReview, Command::kStepExport}) {
        steps->addAction(step(command));
        view_->addAction(step(command));
    }
    steps->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    view_->addSeparator();
    view_->addAction(actions_[Command::kBody]);
    before_panels_ = view_->addSeparator();
    view_->addActions(
        {actions_[Command::kResetLayout], actions_[Command::kJobs], actions_[Command::kNextPanel]});
    view_->addSeparator();
    view_->addAction(actions_[Command::kFullScreen]);
}

void WindowMenus::addPanels(const QList<QDockWidget*>& docks) {
    for (QDockWidget* dock : docks)
        view_->insertAction(before_panels_, dock->toggleViewAction());
}

void WindowMenus::buildSuitAndHelp() {
    suit_->setToolTipsVisible(true);  // they say why a command is grey
    help_->addActions({actions_[Command::kDocuments], actions_[Command::kShortcuts], actions_[Command::kTour],
                       actions_[Command::kPutSuitOn], actions_[Command::kNews]});
    help_->addSeparator();
    help_->addActions({actions_[Command::kSaveDiagnosis], actions_[Command::kAbout]});
}

void WindowMenus::showPageActions(Step step, const QList<QAction*>& page_actions) {
    suit_->clear();
    suit_->addActions({actions_[Command::kPerformer], actions_[Command::kPutSuitOn],
                       actions_[Command::kResetPlace], actions_[Command::kResetPlaceLater]});
    take_->clear();
    take_->addActions({actions_[Command::kRecord], actions_[Command::kImportTakes]});
    QMenu* menu = step == Step::kPerformer || step == Step::kRobot ? suit_ : take_;
    if (!page_actions.isEmpty())
        menu->addSeparator();
    menu->addActions(page_actions);
}

}  // namespace noctule::ui
