// SPDX-License-Identifier: Apache-2.0
// The take under review: its document, the moment and the part of the body that are looked at, and what
// changes it.
#pragma once

#include "ui/models/contact_editor.h"
#include "ui/models/marker_editor.h"
#include "ui/models/selection.h"
#include "ui/models/shared_context.h"
#include "ui/models/take_changes.h"
#include "ui/models/take_document.h"
#include "ui/models/time_cursor.h"

namespace noctule::ui {

class ReviewContext {
public:
    /// `shared` outlives it.
    explicit ReviewContext(SharedContext& shared);

    SharedContext& shared() { return shared_; }
    TakeDocument& take() { return take_; }
    TimeCursor& time() { return time_; }
    /// Of the suit that is connected, too.
    Selection& selection() { return selection_; }
    TakeChanges& changes() { return changes_; }
    MarkerEditor& markers() { return markers_; }
    ContactEditor& contacts() { return contacts_; }
    /// A take of no session, once it proves to be one; until then what is open stays open. A job.
    void openLoose(const QString& path);
    /// Of a torn take; a job. One of the session is replaced and kept in the trash, of any other a copy is
    /// made beside it and opened.
    void saveReadable(const QString& path);
    /// The chosen take that cannot be opened since its file is torn, and why, as a sentence; empty: none.
    struct Unreadable {
        QString path, why;
    };
    const Unreadable& unreadable() const { return unreadable_; }

private:
    void showLoose(const QString& path);
    void openChosenTake(int index);
    void followTake();
    void keepShownResult();
    void tellTorn(int index);

    SharedContext& shared_;
    TimeCursor time_;
    Selection selection_;
    TakeDocument take_;
    int asked_ = 0;  ///< a file that was asked for before another take does not take its place
    TakeChanges changes_;
    MarkerEditor markers_;
    ContactEditor contacts_;
    Unreadable unreadable_;
    QString seen_path_;  ///< of the take that was opened last
    QObject here_;       ///< receives what is told; gone before all others
};

}  // namespace noctule::ui
