// SPDX-License-Identifier: Apache-2.0
// The open session with undo: every change of the operator is a command on the stack and is on disk within a
// second. Takes appear here as they are in the folder.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "core/session/session.h"
#include "ui/jobs/jobs.h"
#include "ui/models/session_saver.h"
#include "ui/models/undo_history.h"

namespace noctule {
struct TakeTransfer;
}

namespace noctule::ui {

class SessionModel : public QObject {
    Q_OBJECT
public:
    /// `home`: the folder in which sessions by date are made.
    SessionModel(Jobs& jobs, std::function<QString()> home, QObject* parent = nullptr);
    ~SessionModel() override;  ///< saves

    bool isOpen() const { return session_.has_value(); }
    /// Only while open.
    const Session& session() const { return *session_; }
    UndoHistory& undoStack() { return undo_; }

    /// Whether its folder cannot be written, so that no change is kept.
    bool isReadOnly() const { return is_read_only_; }
    void setReadOnly(bool is_read_only);

    /// Of session().takes[take]'s file.
    QString takePath(int take) const;
    int currentTake() const { return current_; }  ///< index into session().takes, -1: none
    void setCurrentTake(int index);
    /// Of the take with that file; -1: none of the session.
    int indexOf(const QString& take_path) const;
    /// The result that Review shows of a take; empty: its last. Kept with the session, but no step to be
    /// undone, and nobody is told.
    void keepShownResult(int take, const QString& result);

    /// What the first performer of a session is called until somebody names it.
    static QString firstPerformer();
    bool create(const QString& folder, const QString& name);  ///< false: failed() was emitted
    /// Makes one by date when none is open; false: failed() was emitted.
    bool makeSure();
    /// In words, when the open session's folder has vanished (a drive that was unplugged), else empty.
    QString whyNotHere() const;
    /// A job; opened() or failed(). The take named becomes the current one, else the one that was current
    /// when the session was last open.
    void open(const QString& folder, const QString& take = {});
    /// Makes a new session.json from the takes (after damaged()) and opens it; a job.
    void rebuild(const QString& folder);
    void close();

    // Commands with undo. Indices into session().takes.
    void rate(int take, int rating);
    void setTakeNotes(int take, const QString& notes);
    /// `merge_key`: as of changePerformer().
    void setTakeRange(int take, double in_s, double out_s, const QString& merge_key = {});
    void renameSession(const QString& name);
    void setNotes(const QString& notes);
    void addPerformer(const Performer& performer);
    /// Changes of one kind in quick succession (dragging a gizmo) become one step when `merge_key` is the
    /// same. A new name also goes to the takes of this performer.
    void changePerformer(int index, const Performer& performer, const QString& what,
                         const QString& merge_key = {});
    /// The last one stays.
    void removePerformer(int index);
    void setCurrentPerformer(const QString& name);
    /// A file in the session's calibration/; empty: none. `what` stands in the Edit menu.
    void setCalibration(const QString& file, const QString& what);
    /// Of one suit of several.
    void setSuitCalibration(const QString& serial, const QString& file, const QString& what);
    /// In words why a file in calibration/ cannot be put aside, else empty.
    QString whyNotAside(const QString& file) const;
    /// With its report, into the session's folder of such. False: it stays, and failed() was emitted.
    bool putCalibrationAside(const QString& file);
    /// What views, pictures and exports show.
    void setBody(const SessionBody& body);
    /// The shot list; what only the file knows of a shot stays with its name.
    void setShots(std::vector<Shot> shots);
    void trashTake(int take);
    /// Its file too; what cannot be part of a file's name becomes "_".
    void renameTake(int take, const QString& name);

    /// To the session in another folder, with all that belongs to the take; a job, then for a move a step
    /// that can be undone. Where the name is taken, both takes are kept.
    enum class Transfer { kMove, kCopy };
    /// No session in the folder: the folder's name.
    static QString nameOfSession(const QString& folder);
    void transferTake(int take, const QString& folder, Transfer how);

    // Not undone: files come, nothing goes.
    void importTakes(const QStringList& paths);  ///< a job
    /// Finishes a take whose recording broke off; a job.
    void recover(int take);
    bool isRecovering(const std::string& take) const { return recovering_.count(take) > 0; }
    /// What recovering a damaged take saved of it: whole sentences, for a warning.
    static QString savedInWords(const QString& take, const TakeLosses& losses);
    /// Looks at a take's file again; one that has come into the folder is added.
    void refresh(const QString& take_path);
    void saveNow();

    /// While the result lives, somebody works on the take's file: it is neither renamed nor trashed.
    std::shared_ptr<void> keepInPlace(const QString& take_path);

signals:
    // By the operator, who can take it back:
    void takeTrashed(const QString& name);
    void takeMoved(const QString& outcome);  ///< says to where, as a sentence without its stop
    void exchanged();                        ///< comes before opened(): what was told before is over
    void opened();                           ///< or closed
    void changed();                          ///< anything of the session
    void currentTakeChanged(int index);
    void takeAdded(const QString& name);  ///< imported
    void failed(const QString& message);
    /// Nothing failed, but it should be known: whole sentences.
    void warned(const QString& message);
    /// A session is opened, or something of it changed, imported or moved: what failed before is over.
    void triedAnew();
    void notSaved(const QString& message);
    /// What notSaved() has told is over.
    void savedAgain(const QString& message);
    /// Opening failed in a way that rebuild() may mend; instead of failed(). `problem` is a sentence without
    /// its stop and says which takes are safe.
    void damaged(const QString& folder, const QString& problem);
    /// Its file is replaced from here on, or that has ended.
    void recoveryChanged(int take);
    /// Comes before changed().
    void takeRenamed(const QString& old_path, const QString& new_path);

private:
    friend class SessionCommand;
    using Step = std::function<Status(Session&)>;
    /// Does it; `undo` must take back exactly what `redo` did. What failed is not kept, nor does it cost what
    /// could be done again.
    bool push(const QString& what, Step redo, Step undo, const QString& merge_key = {});
    bool apply(const Step& step);
    void adopt(Session session, const QString& take);
    void openWith(const JobTitle& title, const QString& folder, const QString& take,
                  std::function<Result<Session>(const JobContext&)> work);
    void leave();
    void announce();
    void noteChange();
    void followCurrentTake();
    void tell(const QString& what_failed, const Error& error);
    QString pushMove(TakeTransfer transfer);
    static QString failureText(const QString& what_failed, const Error& error);
    Status mayMove(const std::string& take) const;
    Status moveTake(Session& session, const std::string& from, const std::string& to);

    Jobs& jobs_;
    const std::function<QString()> home_;
    SessionSaver saver_;
    QString unsaved_;  ///< why, as it was told
    std::optional<Session> session_;
    UndoHistory undo_;
    int current_ = -1;
    std::string current_name_;
    bool is_read_only_ = false;
    QPointer<Job> opening_;
    std::set<std::string> recovering_;
    std::map<QString, std::weak_ptr<void>> kept_;  ///< by path
};

}  // namespace noctule::ui
