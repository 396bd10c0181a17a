// SPDX-License-Identifier: Apache-2.0
// The open session with undo: every change of the operator is a command on the stack and is on disk within a
// second. Takes appear here as they are in the folder.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <memory>

#include "core/session/session.h"
#include "ui/jobs/jobs.h"

namespace noctule::ui {

class SessionModel : public QObject {
    Q_OBJECT
public:
    explicit SessionModel(Jobs& jobs, QObject* parent = nullptr);
    ~SessionModel() override;  ///< saves

    bool isOpen() const { return session_.has_value(); }
    /// Only while open.
    const Session& session() const { return *session_; }
    QUndoStack& undoStack() { return undo_; }

    int currentTake() const { return current_; }  ///< index into session().takes, -1: none
    void setCurrentTake(int index);

    bool create(const QString& folder, const QString& name);  ///< false: failed() was emitted
    void open(const QString& folder);                         ///< a job; opened() or failed()
    void close();

    // Commands with undo. Indices into session().takes.
    void rate(int take, int rating);
    void setTakeNotes(int take, const QString& notes);
    void setTakeRange(int take, double in_s, double out_s);
    void renameSession(const QString& name);
    void addPerformer(const Performer& performer);
    /// Changes of one kind in quick succession (dragging a gizmo) become one step when `merge_key` is the
    /// same.
    void changePerformer(int index, const Performer& performer, const QString& what,
                         const QString& merge_key = {});
    void removePerformer(int index);
    void setCurrentPerformer(const QString& name);
    void trashTake(int take);

    void importTakes(const QStringList& paths);  ///< a job
    /// Looks at a take's file again.
    void refresh(const QString& take_path);
    void saveNow();

signals:
    void opened();   ///< or closed
    void changed();  ///< anything of the session
    void currentTakeChanged(int index);
    void failed(const QString& message);

private:
    void push(const QString& what, std::function<void(Session&)> change, const QString& merge_key = {});

    friend class SessionCommand;
    Jobs& jobs_;
    std::optional<Session> session_;
    QUndoStack undo_;
    int current_ = -1;
    QTimer save_timer_;
};

}  // namespace noctule::ui
