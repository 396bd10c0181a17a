// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/recent_sessions.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <algorithm>

#include "core/review/take_review.h"
#include "core/session/session.h"
#include "ui/language/core_words.h"
#include "ui/models/session_marker.h"

namespace noctule::ui {
namespace {

constexpr const char* kRecentGroup = "recent";

bool hasBrokenOff(const SessionTake& take) {
    return take.state == TakeState::kRecording || take.state == TakeState::kRecovered;
}

/// Its calibration makes it one; what else does is known only once all of it was judged, which takes long.
bool isNotUsable(const std::string& path, const JobContext& job) {
    const auto overview = overviewTake(path, job);
    return !overview || overview->runs.empty() ||
           (!overview->has_reference &&
            gradeOf(overview->lack, overview->runs.back().settings.sensors) == Grade::kNotUsable);
}

/// The newest take that neither broke off nor is unusable, else the newest with a result. Empty: none has
/// one.
QString takeForPicture(const Session& session, const JobContext& job) {
    std::string newest;
    for (auto take = session.takes.rbegin(); take != session.takes.rend(); ++take) {
        if (!take->processed || job.cancelled())
            continue;
        const std::string path = session.pathOf(*take).string();
        if (!hasBrokenOff(*take) && !isNotUsable(path, job))
            return QString::fromStdString(path);
        if (newest.empty())
            newest = path;
    }
    return QString::fromStdString(newest);
}

void addTake(RecentSession& recent, const Session& session, const SessionTake& take) {
    const QString path = QString::fromStdString(session.pathOf(take).string());
    ++recent.takes;
    recent.duration_s += take.duration_s;
    recent.take_names.append(QString::fromStdString(take.name));
    recent.damaged += take.state == TakeState::kDamaged;
    recent.unprocessed += take.state != TakeState::kDamaged && !take.processed;
    const bool broke_off = hasBrokenOff(take);
    // Once it was recovered and processed it is a take as others are.
    if (broke_off && !(take.state == TakeState::kRecovered && take.processed))
        recent.interrupted.push_back(
            {QString::fromStdString(take.name), path, take.duration_s, take.state == TakeState::kRecovered});
}

}  // namespace

RecentSession lookAt(RecentSession recent, const JobContext& job) {
    RecentSession found;
    found.folder = recent.folder;
    found.opened = recent.opened;
    found.known = true;
    found.name = QFileInfo(recent.folder).fileName();
    if (!QFileInfo(recent.folder).isDir()) {
        found.problem = RecentSessions::tr("The folder is not there");
        return found;
    }
    const auto session = openSession(recent.folder.toStdString(), job);
    if (!session) {
        found.problem = coreWords(session.error().message);
        found.can_rebuild = canRebuildSession(recent.folder.toStdString());
        return found;
    }
    found.name = QString::fromStdString(session->name);
    found.performer = QString::fromStdString(session->current_performer);
    found.left_open = SessionMarker::wasLeftBehind(recent.folder);
    for (const SessionTake& take : session->takes)
        addTake(found, *session, take);
    found.newest_take = takeForPicture(*session, {nullptr, job.cancel});
    if (SessionMarker::isOpenElsewhere(recent.folder))
        found.interrupted.clear();  // it may be recording
    return found;
}

RecentSessions::RecentSessions(QSettings& settings, Jobs& jobs, QObject* parent)
    : QObject(parent), settings_(settings), jobs_(jobs) {
    const int count = settings_.beginReadArray(kRecentGroup);
    for (int i = 0; i < std::min(count, kMost); ++i) {
        settings_.setArrayIndex(i);
        RecentSession session;
        session.folder = settings_.value("folder").toString();
        session.opened = settings_.value("opened").toDateTime();
        session.name = QFileInfo(session.folder).fileName();
        if (!session.folder.isEmpty())
            sessions_.push_back(session);
    }
    settings_.endArray();
}

QStringList RecentSessions::foldersIn(QSettings& settings) {
    QStringList folders;
    const int count = settings.beginReadArray(kRecentGroup);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        folders += settings.value("folder").toString();
    }
    settings.endArray();
    folders.removeAll({});
    return folders;
}

void RecentSessions::remember(const QString& folder, const QDateTime& now) {
    RecentSession session;
    session.folder = QDir::cleanPath(folder);
    session.opened = now;
    session.name = QFileInfo(session.folder).fileName();
    std::erase_if(sessions_, [&](const RecentSession& other) { return other.folder == session.folder; });
    sessions_.insert(sessions_.begin(), session);
    if (sessions_.size() > kMost)
        sessions_.resize(kMost);
    save();
}

void RecentSessions::remove(const QString& folder) {
    std::erase_if(sessions_, [&](const RecentSession& session) { return session.folder == folder; });
    save();
}

void RecentSessions::save() {
    settings_.beginWriteArray(kRecentGroup, static_cast<int>(sessions_.size()));
    for (size_t i = 0; i < sessions_.size(); ++i) {
        settings_.setArrayIndex(static_cast<int>(i));
        settings_.setValue("folder", sessions_[i].folder);
        settings_.setValue("opened", sessions_[i].opened);
    }
    settings_.endArray();
    emit changed();
}

void RecentSessions::look() {
    if (sessions_.empty())
        return;
    const int generation = ++generation_;
    jobs_.start<std::vector<RecentSession>>(
        tr("Looking at recent sessions"),
        [sessions = sessions_](const JobContext& job) -> Result<std::vector<RecentSession>> {
            std::vector<RecentSession> found;
            for (const RecentSession& session : sessions) {
                if (job.cancelled())
                    return JobContext::cancelledError();
                found.push_back(lookAt(session, job));
            }
            return found;
        },
        [self = QPointer(this), generation](Result<std::vector<RecentSession>> found) -> QString {
            if (!self || !found || generation != self->generation_)
                return {};
            for (RecentSession& session : self->sessions_)
                for (const RecentSession& other : *found)
                    if (other.folder == session.folder) {
                        const QDateTime opened = session.opened;
                        session = other;
                        session.opened = opened;
                    }
            emit self->changed();
            return {};
        },
        Jobs::Loudness::kQuiet);
}

}  // namespace noctule::ui
