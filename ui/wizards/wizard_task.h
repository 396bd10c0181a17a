// SPDX-License-Identifier: Apache-2.0
// The calibrations that have a wizard, and what each says of itself: what is needed, how long it takes, its
// steps and what to do in each.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/suit/calibration_steps.h"
#include "ui/wizards/rig_drawing.h"

namespace noctule::ui {

enum class WizardTask {
    kSources,
    kAccelerometers,
    kGyroscopes,
    kMagnetometers,
    kRestPose,
    kMovement,
    kCheck
};

inline constexpr WizardTask kWizardTasks[] = {
    WizardTask::kSources,  WizardTask::kAccelerometers, WizardTask::kGyroscopes, WizardTask::kMagnetometers,
    WizardTask::kRestPose, WizardTask::kMovement,       WizardTask::kCheck};

struct WizardWords {
    QString title, icon;
    QString what;          ///< it finds out, one sentence
    QString takes;         ///< "Boards on the level plate, six sides, about 4 minutes; every three months"
    QStringList needs;     ///< what must be at hand, one line each
    QString set_up;        ///< how things stand before it begins, with what protects cables
    QString in_any_order;  ///< a sentence for the rail, which is seen before it begins, too
    QString headline;      ///< what to do first
};
WizardWords wordsOf(WizardTask task);

/// Whose values it finds; the check finds none.
std::optional<CalibrationStep> stepOf(WizardTask task);
/// As in calibrations and on the command line: "accelerometers", "rest-pose".
QString keyOf(WizardTask task);
/// Kind of the takes that it works on.
QString takeKindOf(WizardTask task);
/// A step must be right for so long.
double holdOf(WizardTask task);
/// What is kept of a step begins so long before it was right: a movement with the rest pose it came from.
double leadOf(WizardTask task);
/// Somebody wears the suit and stands still in the rest pose.
bool isWorn(WizardTask task);

struct StepWords {
    QString name, hint;   ///< in the rail: "Side 3", "edge A down"
    QString instruction;  ///< large: "Stand the plate on edge B, against the block"
};
/// `up`: of the six sides, which shall point up; of other tasks the step's number. `label`: of a placement.
StepWords stepWordsOf(WizardTask task, int step, int up, const QString& label);

RigPicture::Kind pictureOf(WizardTask task);

}  // namespace noctule::ui
