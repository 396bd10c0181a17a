// SPDX-License-Identifier: Apache-2.0
// A page of the main window: its centre, and what it puts into the docks left and right of it. The main
// window keeps one page per step and shows docks, actions and title of the current one.
#pragma once

#include <QAction>
#include <QList>
#include <QWidget>

namespace noctule::ui {

/// Pages get a Studio& in their constructor and outlive nothing of it. Docks are made once, with the page;
/// the main window takes them over as content of its dock widgets.
class Page : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    virtual QString title() const = 0;
    /// The same one at every call; null: this side stays closed.
    virtual QWidget* leftDock() { return nullptr; }
    virtual QWidget* rightDock() { return nullptr; }
    QString leftDockTitle() const { return left_title_; }
    QString rightDockTitle() const { return right_title_; }

    /// For the menus, in their order; a separator is an action with isSeparator(). All of them are also in
    /// QWidget::actions(). Shortcuts act while the page or one of its docks has the focus or nothing has it
    /// (Qt::WindowShortcut); the main window disables the actions of pages that are not shown.
    virtual QList<QAction*> menuActions() const { return actions(); }

    /// Shown as the current step from now on, or no longer.
    virtual void enter() {}
    virtual void leave() {}

protected:
    void setDockTitles(const QString& left, const QString& right);

signals:
    void dockTitlesChanged();

private:
    QString left_title_, right_title_;
};

}  // namespace noctule::ui
