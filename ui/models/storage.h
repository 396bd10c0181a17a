// SPDX-License-Identifier: Apache-2.0
// How much room there is for takes, and how long can be recorded into it: the one number of all screens.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>

#include "ui/jobs/jobs.h"

namespace noctule::ui {

/// Of a suit of 18 boards at 150 kHz and 16 bit, uncompressed: 5.4 MB a second.
inline constexpr double kUsualBytesPerSecond = 18 * 150'000.0 * 2;

/// Until the recorder ends a take for want of room.
double recordingSeconds(qint64 free_bytes, double bytes_per_s);

/// Free bytes of the volume that holds the folder or, when it is not there yet, its nearest parent; -1:
/// cannot be told. May block on a network.
qint64 freeBytesAt(const QString& folder);

/// Looks at the volume of a folder every 20 seconds, by a job.
class StorageWatch : public QObject {
    Q_OBJECT
public:
    StorageWatch(Jobs& jobs, std::function<QString()> folder, QObject* parent = nullptr);

    qint64 freeBytes() const { return free_bytes_; }  ///< -1: not known
    void look();

signals:
    void changed();

private:
    Jobs& jobs_;
    const std::function<QString()> folder_;
    qint64 free_bytes_ = -1;
    QPointer<Job> looking_;
    QString looked_at_;  ///< the folder of the last job
    QTimer timer_;
};

}  // namespace noctule::ui
