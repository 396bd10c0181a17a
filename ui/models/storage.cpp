// SPDX-License-Identifier: Apache-2.0
#include "ui/models/storage.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QStorageInfo>
#include <algorithm>

#include "devices/live/recorder.h"

namespace noctule::ui {
namespace {

constexpr int kLookAtDisk_ms = 20'000;

}  // namespace

double recordingSeconds(qint64 free_bytes, double bytes_per_s) {
    return std::max(0.0, static_cast<double>(free_bytes - RecorderSettings{}.reserve_bytes) / bytes_per_s);
}

qint64 freeBytesAt(const QString& folder) {
    QString path = QDir::cleanPath(folder);
    while (!QFileInfo::exists(path) && !QDir(path).isRoot())
        path = QFileInfo(path).path();
    const QStorageInfo volume(path);
    return volume.isValid() ? volume.bytesAvailable() : -1;
}

StorageWatch::StorageWatch(Jobs& jobs, std::function<QString()> folder, QObject* parent)
    : QObject(parent), jobs_(jobs), folder_(std::move(folder)) {
    connect(&timer_, &QTimer::timeout, this, &StorageWatch::look);
    timer_.start(kLookAtDisk_ms);
    QTimer::singleShot(0, this, &StorageWatch::look);
}

void StorageWatch::look() {
    const QString folder = folder_();
    // A folder that hangs on a network is asked once, not every 20 seconds.
    if (looking_ && looking_->state() == Job::State::kRunning && looked_at_ == folder)
        return;
    looked_at_ = folder;
    looking_ = jobs_.start<qint64>(
        {tr("Room on %1"), folder},
        [folder](const JobContext&) -> Result<qint64> { return freeBytesAt(folder); },
        [self = QPointer(this), folder](Result<qint64> free_bytes) -> QString {
            if (self && free_bytes && self->looked_at_ == folder) {
                self->free_bytes_ = *free_bytes;
                emit self->changed();
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
}

}  // namespace noctule::ui
