// SPDX-License-Identifier: Apache-2.0
// The docks left and right of the page. Each page brings its own content; where the docks stand, how wide
// they are and whether they float is kept per step and comes back with it. Another size of text brings the
// usual widths.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>
#include <map>

#include "ui/models/studio.h"

class QStackedWidget;

namespace noctule::ui {

class Page;
class ToolButton;
class DockTitle;
class PanelTab;

class SideDocks : public QObject {
    Q_OBJECT
public:
    SideDocks(QMainWindow& window, QSettings& settings);

    /// Keeps the layout of the step before and shows this one's.
    void show(Step step, Page& page);
    /// Writes the present layout to the settings.
    void keep();
    /// Back to how this step's docks were at first.
    void reset();
    /// The page goes away; its content goes back to it.
    void release(Page& page);

    QDockWidget& left() { return *left_.dock; }
    QDockWidget& right() { return *right_.dock; }
    /// Above the page, seen while their dock has given its room to it.
    PanelTab& leftTab() { return *left_.tab; }
    PanelTab& rightTab() { return *right_.tab; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Side {
        QDockWidget* dock;
        QStackedWidget* stack;
        DockTitle* title;
        QAction* action;
        PanelTab* tab;
    };
    Side makeSide(Qt::DockWidgetArea area, const QString& name, const QString& words);
    void fill(const Side& side, QWidget* content, const QString& title);
    void restore();
    bool hasRoomForBoth() const;
    bool areBothSeen() const;
    /// With large type or in a small window the page itself needs the room: one dock goes, usually the left
    /// one, leaves a tab above the page, and comes back when there is room again. Where both stay they may
    /// not cut the page.
    void makeRoom();
    /// The operator wants to see this one: without room for both, the other one goes.
    void preferTo(QDockWidget& other);
    void giveRoom(QDockWidget& dock);
    void showTabs();
    /// As wide as the style guide says, at the present size of text.
    void resizeToUsual(int tries);
    QString key() const;

    QMainWindow& window_;
    QSettings& settings_;
    Side left_, right_;
    Step step_ = Step::kStart;
    Page* page_ = nullptr;
    QPointer<QDockWidget> gave_room_;  ///< comes back when there is room for both
};

}  // namespace noctule::ui
