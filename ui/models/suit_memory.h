// SPDX-License-Identifier: Apache-2.0
// What was calibrated of each suit, by the serial number of its driver box, in the user's data folder: it
// outlives sessions. Values of sensors and sources only; the rest pose belongs to a wearing. Every
// calibration stays as a file of its own, the latest counts.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/job/result.h"
#include "core/suit/calibration.h"

namespace noctule::ui {

/// A serial number or time as every file system takes it in a name.
QString fileNameOf(QString words);

class SuitMemory {
public:
    explicit SuitMemory(QString folder) : folder_(std::move(folder)) {}

    /// Calibrations without any calibrated sensor or source are not kept.
    Status keep(const QString& serial, const Calibration& calibration) const;
    /// The latest that can be read; absent: there is none.
    /// `except`: none with the values of one of these.
    std::optional<Calibration> latest(const QString& serial,
                                      const std::vector<Calibration>& except = {}) const;

private:
    QString folderOf(const QString& serial) const;

    const QString folder_;
};

}  // namespace noctule::ui
