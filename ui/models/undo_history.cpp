// SPDX-License-Identifier: Apache-2.0
#include "ui/models/undo_history.h"

#include <utility>

namespace noctule::ui {

void UndoHistory::undo() {
    refused_ = false;
    QUndoStack::undo();
    if (std::exchange(refused_, false))
        QUndoStack::redo();
}

void UndoHistory::redo() {
    refused_ = false;
    QUndoStack::redo();
    if (std::exchange(refused_, false))
        QUndoStack::undo();
}

}  // namespace noctule::ui
