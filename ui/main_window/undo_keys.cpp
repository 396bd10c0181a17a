// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/undo_keys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace noctule::ui {

UndoKeys::UndoKeys(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

/// A key that the focused widget does not claim beforehand becomes the window's shortcut.
bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
    const auto* field =
        event->type() == QEvent::ShortcutOverride ? qobject_cast<QLineEdit*>(watched) : nullptr;
    if (!field)
        return QObject::eventFilter(watched, event);
    auto& key = *static_cast<QKeyEvent*>(event);
    const bool leaves = (key.matches(QKeySequence::Undo) && !field->isUndoAvailable()) ||
                        (key.matches(QKeySequence::Redo) && !field->isRedoAvailable());
    if (leaves)
        event->ignore();
    return leaves;
}

}  // namespace noctule::ui
