// SPDX-License-Identifier: Apache-2.0
// What each calibration does behind its pages: the guide that watches the suit, and the solver, which is the
// one of `noctule --batch calibrate`.
#pragma once

#include <memory>

#include "core/guide/guide.h"
#include "core/processing/calibrate_sensors.h"
#include "ui/wizards/wizard_task.h"

namespace noctule::ui {

/// `distances`: of a jig.
std::unique_ptr<Guide> makeGuide(WizardTask task, const Suit& suit, const Calibration& known,
                                 int sample_rate_hz, const KnownDistances& distances);

Result<CalibrationResult> solveTask(WizardTask task, const CalibrateRequest& request,
                                    const KnownDistances& distances, const JobContext& job);

/// Points of a digitizer, or distances of a tape measure: the header tells.
Result<KnownDistances> readDistances(const QString& path);

}  // namespace noctule::ui
