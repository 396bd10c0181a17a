// SPDX-License-Identifier: Apache-2.0
// What is told above the page about the session: how it was left, who else has it open, recordings that broke
// off or have no poses, a damaged session.json; each with what is safe and the way on.
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/main_window/notices.h"
#include "ui/models/session_marker.h"
#include "ui/models/studio.h"

namespace noctule::ui {

class SessionNotices : public QObject {
    Q_OBJECT
public:
    SessionNotices(Studio& studio, Notices& notices, QObject* parent);

    /// After the session was opened.
    void tellMarker(SessionMarker::Finding finding);
    /// After it was closed.
    void forget();

private:
    void tellTrashed(const QString& name);
    void offerUndo(const QString& title, const QString& text);
    void tellDamaged(const QString& folder, const QString& problem);
    void tellInterrupted();
    void tellPosesMissing(const QString& take);
    /// Its index; negative once it has poses, or went.
    int takeWithoutPoses() const;
    Notice interruptedNotice(const QStringList& names);

    Studio& studio_;
    Notices& notices_;
    QTimer gone_timer_;      ///< of the last Undo that was offered
    bool in_use_ = false;    ///< somewhere else: what is being recorded there is not interrupted
    QStringList told_{};     ///< takes that the notice was about: a closed one stays closed
    QString lacks_poses_{};  ///< name of the take that the notice is about
};

}  // namespace noctule::ui
