// SPDX-License-Identifier: Apache-2.0
// How much room there is for takes, and how long a suit can record into it.
#pragma once

#include <QString>
#include <QtGlobal>

namespace noctule::ui {

struct Storage {
    qint64 free_bytes = -1;  ///< -1: cannot be told
    /// Of 18 boards at 150 kHz and 16 bit, uncompressed: 5.4 MB a second.
    double recordingHours() const;
};

/// Of the volume that holds the folder or, when it is not there yet, its nearest parent. May block on a
/// network.
Storage storageAt(const QString& folder);

}  // namespace noctule::ui
