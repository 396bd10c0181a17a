// SPDX-License-Identifier: Apache-2.0
// The menus File, Edit, View, Suit, Take and Help from the commands of the window, of its docks and of the
// present page.
#pragma once

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "ui/main_window/window_actions.h"
#include "ui/models/studio.h"
#include "ui/views/session/recent_sessions.h"

namespace noctule::ui {

class WindowMenus : public QObject {
    Q_OBJECT
public:
    WindowMenus(WindowActions& actions, RecentSessions& recent, QMenuBar& bar);

    void addPanels(const QList<QDockWidget*>& docks);
    /// Into Take, or into Suit for the performer page.
    void showPageActions(Step step, const QList<QAction*>& actions);
    QList<QMenu*> all() const { return {file_, edit_, view_, suit_, take_, help_}; }

signals:
    void recentRequested(const QString& folder);

private:
    void buildFile();
    void buildView();
    void buildSuitAndHelp();
    void fillRecent();

    WindowActions& actions_;
    RecentSessions& recent_;
    QMenu *file_, *edit_, *view_, *suit_, *take_, *help_, *recent_menu_;
    QAction* before_panels_;
};

}  // namespace noctule::ui
