// SPDX-License-Identifier: Apache-2.0
// One step on the undo stack of a session: what it changes and how to take it back. It has been done when it
// comes onto the stack, and a step that fails changes nothing.
#pragma once

#include <QElapsedTimer>
#include <QUndoCommand>

#include "ui/models/session_model.h"

namespace noctule::ui {

class SessionCommand : public QUndoCommand {
public:
    SessionCommand(SessionModel& model, const QString& what, SessionModel::Step redo, SessionModel::Step undo,
                   const QString& merge_key);

    void redo() override;
    void undo() override;
    int id() const override;  ///< -1: never merged
    bool mergeWith(const QUndoCommand* later) override;

private:
    void take(const SessionModel::Step& step, bool done);

    SessionModel& model_;
    SessionModel::Step redo_, undo_;
    QString merge_key_;
    QElapsedTimer since_last_;
    bool is_done_ = true;
};

}  // namespace noctule::ui
