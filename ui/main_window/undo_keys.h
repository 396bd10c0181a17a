// SPDX-License-Identifier: Apache-2.0
// Undo and redo keys in text fields: a field that has nothing of its own to take back leaves them to the
// window. Qt's fields keep them in any case, and what was typed a field before could not be taken back.
#pragma once

#include <QObject>

namespace noctule::ui {

class UndoKeys : public QObject {
    Q_OBJECT
public:
    /// For all fields of the application as long as it lives.
    explicit UndoKeys(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace noctule::ui
