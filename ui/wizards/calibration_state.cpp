// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/calibration_state.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/suit/calibration_lack.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

struct StateText {
    Q_DECLARE_TR_FUNCTIONS(CalibrationState)
};

/// As the wizards' own words say: once a year, every three months, each time the suit is put on.
int lastsDays(WizardTask task) {
    switch (task) {
        case WizardTask::kSources:
            return 365;
        case WizardTask::kAccelerometers:
        case WizardTask::kGyroscopes:
        case WizardTask::kMagnetometers:
            return 92;
        case WizardTask::kRestPose:
        case WizardTask::kMovement:
        case WizardTask::kCheck:
            break;
    }
    return 0;
}

int severity(const QString& verdict) {
    return verdict == "good" ? 0 : verdict == "usable" ? 1 : 2;
}

/// Of the parts whose values count as calibrated or not (calibration_lack.h); null: of other tasks.
const std::vector<int>* lackingParts(WizardTask task, const CalibrationLack& lack) {
    switch (task) {
        case WizardTask::kSources:
            return &lack.sources;
        case WizardTask::kAccelerometers:
            return &lack.accelerometers;
        case WizardTask::kGyroscopes:
            return &lack.gyroscopes;
        case WizardTask::kRestPose:
            return &lack.rest_pose;
        case WizardTask::kMagnetometers:
        case WizardTask::kMovement:
        case WizardTask::kCheck:
            break;
    }
    return nullptr;
}

template <class Part>
void count(const Part* part, const std::string& key, bool lacks, TaskState& state) {
    ++state.parts;
    if (!part || !part->made.contains(key)) {
        state.unstated += part && !lacks;
        return;
    }
    const CalibrationMade& made = part->made.at(key);
    ++state.made;
    const QDateTime when = QDateTime::fromString(QString::fromStdString(made.created_utc), Qt::ISODate);
    if (!state.oldest.isValid() || when < state.oldest)
        state.oldest = when;
    const QString verdict = QString::fromStdString(made.verdict);
    if (state.worst.isEmpty() || severity(verdict) > severity(state.worst))
        state.worst = verdict;
}

}  // namespace

Tone TaskState::tone() const {
    if (made == 0)
        return unstated == 0 || isComplete() ? Tone::kNeutral : Tone::kWarn;
    if (worst == "not usable")
        return Tone::kError;
    return made < parts || is_old || worst != "good" ? Tone::kWarn : Tone::kOk;
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
    const QString when = dateInside(oldest.toLocalTime());
    return is_old ? StateText::tr("%1 of %2 parts, %3, since %4: due again")
                        .arg(made)
                        .arg(parts)
                        .arg(grade, when)
                  : StateText::tr("%1 of %2 parts, %3, since %4").arg(made).arg(parts).arg(grade, when);
}

TaskState stateOf(WizardTask task, const std::optional<Calibration>& calibration, const Suit& suit,
                  const QDateTime& now) {
    TaskState state;
    const std::string key = keyOf(task).toStdString();
    const Calibration none;
    const Calibration& known = calibration ? *calibration : none;
    const CalibrationLack lack = lackOf(suit, known);
    const std::vector<int>* lacking = lackingParts(task, lack);
    const auto lacks = [lacking](size_t part) {
        return !lacking || std::ranges::count(*lacking, static_cast<int>(part)) > 0;
    };
    if (task == WizardTask::kSources) {
        for (size_t s = 0; s < suit.sources.size(); ++s)
            count(known.findSource(suit.sources[s].id), key, lacks(s), state);
        if (suit.sources.empty())
            for (const SourceCalibration& source : known.sources)
                count(&source, key, true, state);
    } else {
        for (size_t b = 0; b < suit.boards.size(); ++b)
            if (task != WizardTask::kMagnetometers || suit.boards[b].has_magnetometer)
                count(known.findBoard(suit.boards[b].id), key, lacks(b), state);
        if (suit.boards.empty())
            for (const BoardCalibration& board : known.boards)
                count(&board, key, true, state);
    }
    state.is_old = state.oldest.isValid() && state.oldest.daysTo(now) > lastsDays(task);
    return state;
}

std::optional<WizardTask> nextTask(const std::optional<Calibration>& calibration, const Suit& suit,
                                   const QDateTime& now) {
    for (const WizardTask task : {WizardTask::kSources, WizardTask::kAccelerometers, WizardTask::kGyroscopes,
                                  WizardTask::kRestPose}) {
        if (suit.isFixed() && task != WizardTask::kSources)
            break;  // anchors: nobody wears their boards
        const TaskState state = stateOf(task, calibration, suit, now);
        if (!state.isComplete() || state.is_old || state.worst == "not usable")
            return task;
    }
    return std::nullopt;
}

}  // namespace noctule::ui
