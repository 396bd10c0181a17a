// SPDX-License-Identifier: Apache-2.0
// Writes into the log what the studio does: sessions and takes that are opened, jobs and how they ended, the
// suit's connection, everything that failed or was warned of. Names of people, takes and files are left out.
#pragma once

#include <QObject>
#include <QStringList>

#include "ui/models/log_file.h"
#include "ui/models/studio.h"

namespace noctule::ui {

class StudioLog : public QObject {
    Q_OBJECT
public:
    StudioLog(Studio& studio, LogFile& log, QObject* parent = nullptr);

private:
    /// Names that users gave become numbers, paths are left out: a log may be passed on.
    void write(const char* level, const QString& text);
    void learn(const QStringList& names);
    void follow(Job& job);
    void tellPhase(const LiveSuit& suit);

    Studio& studio_;
    LogFile& log_;
    QStringList names_;  ///< that were met since the start; the place of one is its number
};

}  // namespace noctule::ui
