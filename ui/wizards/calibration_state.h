// SPDX-License-Identifier: Apache-2.0
// What a calibration is worth for the suit that is connected: per task, of how many parts it has values, how
// old the oldest are and how good the worst, and what should be done next.
#pragma once

#include <QDateTime>
#include <optional>

#include "core/suit/calibration_steps.h"
#include "ui/style/ink.h"
#include "ui/wizards/wizard_task.h"

namespace noctule::ui {

struct TaskState : CalibrationStepState {
    bool isComplete() const { return parts > 0 && made + unstated == parts; }
    Tone tone() const;
    QString words() const;
};

/// Not of the check, which makes no values. `suit` may be empty: then the calibration's own parts count.
TaskState stateOf(WizardTask task, const std::optional<Calibration>& calibration, const Suit& suit,
                  const QDateTime& now);

/// What is missing or old, in the order in which the calibrations build on each other; absent: nothing.
std::optional<WizardTask> nextTask(const std::optional<Calibration>& calibration, const Suit& suit,
                                   const QDateTime& now);

}  // namespace noctule::ui
