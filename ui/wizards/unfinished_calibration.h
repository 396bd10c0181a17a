// SPDX-License-Identifier: Apache-2.0
// What a wizard has taken so far, as it survives leaving, a crash and another day: a small JSON file in the
// session's calibration/ that names the short takes in calibration/evidence/.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/job/result.h"

namespace noctule::ui {

/// A short take, and what it shows.
struct WizardEvidence {
    QString path;
    int step = 0;
    QString placement;                ///< of a jig; else empty
    std::vector<std::string> boards;  ///< ids
};

struct UnfinishedCalibration {
    QString started_utc;     ///< ISO 8601; empty: nothing has begun
    QString distances_path;  ///< of a jig
    std::vector<WizardEvidence> evidence;
    double share = 0;  ///< of the step under way, where readings are kept as they come

    int stepsDone() const;
};

/// `task` as in WizardTask's key, `serial` of the suit's driver box. Empty: what was kept last of any suit.
QString unfinishedPath(const QString& calibration_folder, const QString& task, const QString& serial);

/// Whatever happens later, this much is there.
Status writeUnfinished(const QString& path, const QString& task, const UnfinishedCalibration& unfinished);

/// Takes that are gone are left out. Nothing when the file is missing or damaged: the takes stay in their
/// folder.
UnfinishedCalibration readUnfinished(const QString& path, const QString& evidence_folder);

}  // namespace noctule::ui
