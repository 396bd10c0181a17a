// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/session_notices.h"

#include <QDir>

#include "ui/views/session/recovery_words.h"

namespace noctule::ui {
namespace {

constexpr const char* kMarkerTopic = "session marker";
constexpr const char* kInterrupted = "interrupted take";
constexpr const char* kDamaged = "damaged session";
constexpr const char* kGone = "take that went";
constexpr const char* kWithoutPoses = "take without poses";
constexpr int kGoneShown_ms = 12000;

}  // namespace

SessionNotices::SessionNotices(Studio& studio, Notices& notices, QObject* parent)
    : QObject(parent), studio_(studio), notices_(notices) {
    connect(&studio.session(), &SessionModel::damaged, this, &SessionNotices::tellDamaged);
    connect(&studio.session(), &SessionModel::changed, this, &SessionNotices::tellInterrupted);
    connect(&studio.session(), &SessionModel::takeTrashed, this, &SessionNotices::tellTrashed);
    connect(&studio.session(), &SessionModel::takeMoved, this,
            [this](const QString& outcome) { offerUndo(outcome, {}); });
    connect(&studio.suits(), &LiveSuits::posesMissing, this, &SessionNotices::tellPosesMissing);
    connect(&studio.session(), &SessionModel::changed, this, [this] {
        if (takeWithoutPoses() < 0)
            notices_.remove(kWithoutPoses);
    });
    connect(&studio.placeReset(), &PlaceReset::wasReset, this, [this](const QString& who) {
        offerUndo(tr("Heading and place of %1 are reset").arg(who),
                  tr("The live picture alone changes; takes stay as they are recorded."));
    });
    gone_timer_.setSingleShot(true);
    connect(&gone_timer_, &QTimer::timeout, this, [this] { notices_.remove(kGone); });
    // Any further step makes Undo mean something else.
    connect(&studio.session().undoStack(), &QUndoStack::indexChanged, this,
            [this] { notices_.remove(kGone); });
}

void SessionNotices::tellPosesMissing(const QString& take) {
    lacks_poses_ = take;
    const auto process = [this] {
        if (const int index = takeWithoutPoses(); index >= 0)
            studio_.processAccurately(studio_.session().takePath(index).toStdString());
    };
    notices_.add({Tone::kWarn, tr("%1 has no poses yet", "name of a take").arg(take),
                  tr("The live view skipped part of the sound; the take holds all of it. Process it."),
                  tr("Process"), process, kWithoutPoses});
}

int SessionNotices::takeWithoutPoses() const {
    if (!studio_.session().isOpen())
        return -1;
    const Session& session = studio_.session().session();
    const int index = session.findTake(lacks_poses_.toStdString());
    return index >= 0 && !session.takes[static_cast<size_t>(index)].processed ? index : -1;
}

void SessionNotices::tellTrashed(const QString& name) {
    offerUndo(tr("%1 was moved to the trash").arg(name), tr("The trash is a folder of the session."));
}

void SessionNotices::offerUndo(const QString& title, const QString& text) {
    notices_.add(
        {Tone::kNeutral, title, text, tr("Undo"), [this] { studio_.session().undoStack().undo(); }, kGone});
    gone_timer_.start(kGoneShown_ms);
}

void SessionNotices::forget() {
    notices_.remove(kGone);
    notices_.remove(kMarkerTopic);
    notices_.remove(kInterrupted);
    notices_.remove(kWithoutPoses);
    in_use_ = false;
    told_.clear();
}

void SessionNotices::tellMarker(SessionMarker::Finding finding) {
    forget();
    notices_.remove(kDamaged);
    in_use_ = finding == SessionMarker::Finding::kInUse;
    const Session& session = studio_.session().session();
    const QString name = QString::fromStdString(session.name);
    Notice notice{Tone::kWarn, {}, {}, {}, {}, kMarkerTopic};
    if (finding == SessionMarker::Finding::kInUse) {
        notice.title = tr("“%1” is open somewhere else as well").arg(name);
        notice.text =
            tr("Takes are safe. Of notes and ratings changed in both places the later ones win; close one of "
               "the two.");
    } else if (finding == SessionMarker::Finding::kNoMarker) {
        notice.title = tr("“%1” can be read but not written").arg(name);
        notice.text =
            tr("Takes can be reviewed and exported to another place; ratings, notes and results cannot be "
               "kept. Copy the folder to where you may write.");
    } else if (finding == SessionMarker::Finding::kLeftBehind) {
        notice.tone = Tone::kNeutral;
        notice.title = tr("“%1” was not closed last time").arg(name);
        notice.text =
            tr("The studio ended unexpectedly. All %n take(s) were looked at again; changes were kept up to "
               "the last second.",
               nullptr, static_cast<int>(session.takes.size()));
    }
    if (!notice.title.isEmpty())
        notices_.add(notice);
    tellInterrupted();
}

void SessionNotices::tellDamaged(const QString& folder, const QString& problem) {
    notices_.add({Tone::kError, tr("“%1” cannot be opened as it is").arg(QDir(folder).dirName()),
                  rebuildOffer(problem), tr("Rebuild session"),
                  [this, folder] { studio_.session().rebuild(folder); }, kDamaged});
}

/// Recordings that broke off can be finished as soon as they are seen.
void SessionNotices::tellInterrupted() {
    QStringList names;
    if (studio_.session().isOpen() && !in_use_)
        for (const SessionTake& take : studio_.session().session().takes)
            if (take.state == TakeState::kRecording && !studio_.session().isRecovering(take.name))
                names.append(QString::fromStdString(take.name));
    if (names == told_)
        return;
    told_ = names;
    if (names.isEmpty())
        notices_.remove(kInterrupted);
    else
        notices_.add(interruptedNotice(names));
}

Notice SessionNotices::interruptedNotice(const QStringList& names) {
    const bool one = names.size() == 1;
    const auto recover = [this, names] {
        SessionModel& session = studio_.session();
        for (const QString& name : names)
            if (session.isOpen())
                session.recover(session.session().findTake(name.toStdString()));
    };
    return {
        Tone::kWarn,
        one ? tr("Take %1 broke off").arg(names.first()) : tr("%n takes broke off", nullptr, names.size()),
        tr("What came in until then is safe on disk: %1. %2", "names of takes, an offer")
            .arg(names.join(QStringLiteral(", ")), recoverOffer()),
        one ? tr("Recover %1").arg(names.first()) : tr("Recover all"),
        recover,
        kInterrupted};
}

}  // namespace noctule::ui
