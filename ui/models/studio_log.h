// SPDX-License-Identifier: Apache-2.0
// Writes into the log what the studio does: sessions and takes that are opened, jobs and how they ended, the
// suit's connection, everything that failed or was warned of.
#pragma once

#include <QObject>

#include "ui/models/log_file.h"
#include "ui/models/studio.h"

namespace noctule::ui {

class StudioLog : public QObject {
    Q_OBJECT
public:
    StudioLog(Studio& studio, LogFile& log, QObject* parent = nullptr);

private:
    void follow(Job& job);
    void tellPhase(const LiveSuit& suit);

    Studio& studio_;
    LogFile& log_;
};

}  // namespace noctule::ui
