// SPDX-License-Identifier: Apache-2.0
#include "ui/views/page_actions.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include "ui/style/keys.h"

namespace noctule::ui {
namespace {

/// As shortcuts are written. On some keyboards a full stop is typed with Shift, which is no part of it then.
QList<QKeySequence> sequencesOf(const QKeyEvent& event) {
    const int modifiers = static_cast<int>(event.modifiers() & ~Qt::KeypadModifier);
    QList<QKeySequence> sequences{QKeySequence(event.key() | modifiers)};
    const QChar typed = event.text().isEmpty() ? QChar() : event.text().front();
    if (typed.isPunct() || typed.isSymbol())
        sequences += QKeySequence(event.key() | (modifiers & ~static_cast<int>(Qt::ShiftModifier)));
    return sequences;
}

/// Text fields leave Ins to their page, where it would change what is behind them.
bool isInsertOfText(const QKeyEvent& event) {
    const QWidget* focus = QApplication::focusWidget();
    return event.key() == Qt::Key_Insert &&
           (qobject_cast<const QLineEdit*>(focus) || qobject_cast<const QPlainTextEdit*>(focus) ||
            qobject_cast<const QTextEdit*>(focus) || qobject_cast<const QAbstractSpinBox*>(focus));
}

}  // namespace

PageActions::PageActions(QWidget& page) : QObject(&page), page_(page) {}

QAction* PageActions::add(const char* name, const QString& text, const QKeySequence& keys,
                          std::function<void()> act) {
    auto* action = new QAction(text, this);
    Keys::get().adopt(*action, name, keys.isEmpty() ? QList<QKeySequence>{} : QList<QKeySequence>{keys});
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, std::move(act));
    page_.addAction(action);
    all_ += action;
    return action;
}

void PageActions::addSeparator() {
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    all_ += separator;
}

bool PageActions::handleKey(const QKeyEvent& event) {
    if (isInsertOfText(event))
        return false;
    const QList<QKeySequence> pressed = sequencesOf(event);
    for (QAction* action : all_)
        if (action->isEnabled() && !action->shortcut().isEmpty() && pressed.contains(action->shortcut())) {
            if (!event.isAutoRepeat() || action->autoRepeat())
                action->trigger();
            return true;
        }
    return false;
}

}  // namespace noctule::ui
