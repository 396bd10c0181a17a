// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/calibration_state.h"

#include <QCoreApplication>

#include "core/job/contract.h"
#include "ui/models/suit_check.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

struct StateText {
    Q_DECLARE_TR_FUNCTIONS(CalibrationState)
};

}  // namespace

Tone TaskState::tone() const {
    if (made == 0)
        return unstated == 0 || isComplete() ? Tone::kNeutral : Tone::kWarn;
    if (isNotUsable())
        return Tone::kError;
    return made < parts || isOld() || worst != "good" ? Tone::kWarn : Tone::kOk;
}

QString TaskState::words() const {
    if (made == 0 && unstated > 0)
        return isComplete() ? StateText::tr("In use; where it comes from is not stated")
                            : StateText::tr("%1 of %2 parts in use; where they come from is not stated")
                                  .arg(unstated)
                                  .arg(parts);
    if (made == 0)
        return StateText::tr("Not calibrated yet");
    const QString grade = worst == "good"     ? StateText::tr("good")
                          : worst == "usable" ? StateText::tr("usable")
                                              : StateText::tr("not usable");
    const QString when = dateInside(madeAt(*this).toLocalTime());
    return isOld() ? StateText::tr("%1 of %2 parts, %3, since %4: due again")
                         .arg(made)
                         .arg(parts)
                         .arg(grade, when)
                   : StateText::tr("%1 of %2 parts, %3, since %4").arg(made).arg(parts).arg(grade, when);
}

TaskState stateOf(WizardTask task, const std::optional<Calibration>& calibration, const Suit& suit,
                  const QDateTime& now) {
    const auto step = stepOf(task);
    require(step.has_value(), "the check has no values");
    return {agedStep(*step, suit, calibration.value_or(Calibration{}), now)};
}

std::optional<WizardTask> nextTask(const std::optional<Calibration>& calibration, const Suit& suit,
                                   const QDateTime& now) {
    for (const WizardTask task : {WizardTask::kSources, WizardTask::kAccelerometers, WizardTask::kGyroscopes,
                                  WizardTask::kRestPose}) {
        if (suit.isFixed() && task != WizardTask::kSources)
            break;  // anchors: nobody wears their boards
        const TaskState state = stateOf(task, calibration, suit, now);
        if (!state.isComplete() || state.isOld() || state.isNotUsable())
            return task;
    }
    return std::nullopt;
}

}  // namespace noctule::ui
