// SPDX-License-Identifier: Apache-2.0
#include "ui/models/storage.h"

#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>

namespace noctule::ui {
namespace {

constexpr double kBytesPerSecond = 18 * 150'000.0 * 2;

}  // namespace

double Storage::recordingHours() const {
    return static_cast<double>(free_bytes) / kBytesPerSecond / 3600;
}

Storage storageAt(const QString& folder) {
    QString path = QDir::cleanPath(folder);
    while (!QFileInfo::exists(path) && !QDir(path).isRoot())
        path = QFileInfo(path).path();
    const QStorageInfo volume(path);
    return {volume.isValid() ? volume.bytesAvailable() : -1};
}

}  // namespace noctule::ui
