// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/calibration_state.h"

#include <QCoreApplication>

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

template <class Part>
void count(const Part* part, const std::string& key, TaskState& state) {
    ++state.parts;
    if (!part || !part->made.contains(key))
        return;
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
        return Tone::kNeutral;
    if (worst == "not usable")
        return Tone::kError;
    return !isComplete() || is_old || worst != "good" ? Tone::kWarn : Tone::kOk;
}

QString TaskState::words() const {
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
    if (task == WizardTask::kSources) {
        for (const Source& source : suit.sources)
            count(known.findSource(source.id), key, state);
        if (suit.sources.empty())
            for (const SourceCalibration& source : known.sources)
                count(&source, key, state);
    } else {
        for (const Board& board : suit.boards)
            if (task != WizardTask::kMagnetometers || board.has_magnetometer)
                count(known.findBoard(board.id), key, state);
        if (suit.boards.empty())
            for (const BoardCalibration& board : known.boards)
                count(&board, key, state);
    }
    state.is_old = state.oldest.isValid() && state.oldest.daysTo(now) > lastsDays(task);
    return state;
}

std::optional<WizardTask> nextTask(const std::optional<Calibration>& calibration, const Suit& suit,
                                   const QDateTime& now) {
    for (const WizardTask task : {WizardTask::kSources, WizardTask::kAccelerometers, WizardTask::kGyroscopes,
                                  WizardTask::kRestPose}) {
        const TaskState state = stateOf(task, calibration, suit, now);
        if (!state.isComplete() || state.is_old || state.worst == "not usable")
            return task;
    }
    return std::nullopt;
}

}  // namespace noctule::ui
