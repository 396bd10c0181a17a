// SPDX-License-Identifier: Apache-2.0
// The docks left and right of the page. Each page brings its own content; where the docks stand, how wide
// they are and whether they float is kept per step and comes back with it.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <map>

#include "ui/models/studio.h"

class QStackedWidget;

namespace noctule::ui {

class Page;
class ToolButton;
class DockTitle;

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

private:
    struct Side {
        QDockWidget* dock;
        QStackedWidget* stack;
        DockTitle* title;
        QAction* action;
    };
    Side makeSide(Qt::DockWidgetArea area, const QString& name, const QString& words);
    void fill(const Side& side, QWidget* content, const QString& title);
    void restore();
    bool hasRoomForBoth() const;
    /// With large type on a small screen the page itself needs the room; the View menu brings the dock back.
    void makeRoom();
    QString key() const;

    QMainWindow& window_;
    QSettings& settings_;
    Side left_, right_;
    Step step_ = Step::kStart;
    Page* page_ = nullptr;
};

}  // namespace noctule::ui
