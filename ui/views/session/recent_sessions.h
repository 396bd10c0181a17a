// SPDX-License-Identifier: Apache-2.0
// The sessions that were open before, newest first, and what can be told of each without opening it: takes,
// times, and whether the studio stopped in it unexpectedly. Folders are looked at by a quiet job.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QSettings>
#include <QStringList>
#include <vector>

#include "core/job/job.h"
#include "ui/jobs/jobs.h"

namespace noctule::ui {

/// A take that was being recorded when the recording stopped unexpectedly.
struct InterruptedTake {
    QString name, path;
    double duration_s = 0;
    bool recovered = false;  ///< false: its file still says "recording"
};

struct RecentSession {
    QString folder;
    QDateTime opened;
    // Known once the folder has been looked at:
    bool known = false;
    QString name, performer;
    QString problem;           ///< a sentence: the folder is not there, session.json is damaged
    bool can_rebuild = false;  ///< session.json can be made again from the takes
    int takes = 0, unprocessed = 0, damaged = 0;
    double duration_s = 0;
    QStringList take_names;
    QString newest_take;  ///< path of a take with a result, for the small picture
    std::vector<InterruptedTake> interrupted;
    bool left_open = false;  ///< the studio ended without closing it
};

/// Reads the folder; runs on any thread.
RecentSession lookAt(RecentSession session, const JobContext& job);

class RecentSessions : public QObject {
    Q_OBJECT
public:
    RecentSessions(QSettings& settings, Jobs& jobs, QObject* parent = nullptr);

    static constexpr int kMost = 20;
    /// Newest first, without looking at them.
    static QStringList foldersIn(QSettings& settings);

    const std::vector<RecentSession>& all() const { return sessions_; }
    /// Puts a folder to the top.
    void remember(const QString& folder, const QDateTime& now = QDateTime::currentDateTime());
    void remove(const QString& folder);
    /// Looks at all folders again.
    void look();

signals:
    void changed();

private:
    void save();

    QSettings& settings_;
    Jobs& jobs_;
    std::vector<RecentSession> sessions_;
    int generation_ = 0;  ///< what an earlier look found is dropped
};

}  // namespace noctule::ui
