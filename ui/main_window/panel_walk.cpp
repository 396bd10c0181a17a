// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/panel_walk.h"

#include <QApplication>

namespace noctule::ui {
namespace {

bool takesKeyboard(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) &&
           !widget.focusProxy();
}

/// The panel itself, or in the order of the Tab key the first part of it that can have the focus.
QWidget* firstIn(QWidget& panel) {
    if (takesKeyboard(panel))
        return &panel;
    QWidget* widget = panel.nextInFocusChain();
    for (; widget && widget != &panel; widget = widget->nextInFocusChain())
        if (panel.isAncestorOf(widget) && takesKeyboard(*widget))
            return widget;
    return nullptr;
}

/// Where the keyboard was last in the panel.
QWidget* lastIn(QWidget& panel) {
    QWidget* widget = panel.focusWidget();
    return widget && panel.isAncestorOf(widget) && takesKeyboard(*widget) ? widget : firstIn(panel);
}

}  // namespace

void walkPanels(const QList<QWidget*>& panels, bool forward) {
    const QWidget* focused = QApplication::focusWidget();
    int at = forward ? -1 : 0;
    for (int i = 0; i < panels.size(); ++i)
        if (focused && (panels[i] == focused || panels[i]->isAncestorOf(focused)))
            at = i;
    for (int step = 1; step <= panels.size(); ++step) {
        const int next = (at + (forward ? step : -step) + 2 * panels.size()) % panels.size();
        if (!panels[next]->isVisible())
            continue;
        if (QWidget* widget = lastIn(*panels[next])) {
            widget->setFocus(Qt::TabFocusReason);
            return;
        }
    }
}

}  // namespace noctule::ui
