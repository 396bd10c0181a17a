// SPDX-License-Identifier: Apache-2.0
#include "ui/models/session_marker.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSysInfo>
#include <cerrno>
#include <csignal>

namespace noctule::ui {
namespace {

QString markerPath(const QString& folder) {
    return QDir(folder).filePath("session.lock");
}

bool isAlive(qint64 process) {
    return process > 0 && (::kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM);
}

}  // namespace

bool SessionMarker::wasLeftBehind(const QString& session_folder) {
    const QString path = markerPath(session_folder);
    if (!QFileInfo::exists(path))
        return false;
    qint64 process = 0;
    QString host, program;
    if (!QLockFile(path).getLockInfo(&process, &host, &program))
        return true;  // a marker that nobody finished writing
    return host == QSysInfo::machineHostName() && !isAlive(process);
}

bool SessionMarker::isOpenElsewhere(const QString& session_folder) {
    qint64 process = 0;
    QString host, program;
    if (!QLockFile(markerPath(session_folder)).getLockInfo(&process, &host, &program))
        return false;
    const bool is_here = host == QSysInfo::machineHostName();
    return !is_here || (process != QCoreApplication::applicationPid() && isAlive(process));
}

SessionMarker::Finding SessionMarker::mark(const QString& session_folder) {
    release();
    const bool left_behind = wasLeftBehind(session_folder);
    auto lock = std::make_unique<QLockFile>(markerPath(session_folder));
    lock->setStaleLockTime(0);  // age says nothing: a session may be open for days
    if (!lock->tryLock(0))
        return lock->error() == QLockFile::LockFailedError ? Finding::kInUse : Finding::kNoMarker;
    lock_ = std::move(lock);
    return left_behind ? Finding::kLeftBehind : Finding::kFree;
}

}  // namespace noctule::ui
