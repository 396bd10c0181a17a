// SPDX-License-Identifier: Apache-2.0
// The operator's steps. A QUndoStack goes past a step whatever becomes of it; here one that cannot be taken
// back or done again at the moment (its take is being worked on, the disk is full) stays where it is.
#pragma once

#include <QUndoStack>

namespace noctule::ui {

class UndoHistory : public QUndoStack {
    Q_OBJECT
public:
    using QUndoStack::QUndoStack;

    /// Told by a command, within its undo() or redo(), that it changed nothing. It is then called once more,
    /// the other way, and must do nothing.
    void refuse() { refused_ = true; }

public slots:
    // Hide those of QUndoStack, also from its actions, which look for slots of these names.
    void undo();
    void redo();

private:
    bool refused_ = false;
};

}  // namespace noctule::ui
