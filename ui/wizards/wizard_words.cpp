// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/guide/placement_guide.h"
#include "core/guide/side_guide.h"
#include "core/guide/stand_guide.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

struct LiveText {
    Q_DECLARE_TR_FUNCTIONS(LiveText)
};

QString askewText(double angle_rad) {
    return degreesText(angle_rad, 1);
}

QString rpmText(double rpm) {
    return numberText(std::abs(rpm), 1);
}

QString silentOthers(const Guidance& now) {
    return now.hindering > 1 ? LiveText::tr("%n other(s) are silent too.", nullptr, now.hindering - 1)
                             : QString();
}

QString turnedOthers(const Guidance& now) {
    return now.hindering > 1 ? LiveText::tr("%n other(s) are turned too.", nullptr, now.hindering - 1)
                             : QString();
}

QString movingOthers(const Guidance& now) {
    return now.hindering > 1 ? LiveText::tr("%n other(s) move too.", nullptr, now.hindering - 1) : QString();
}

QString idleOthers(const Guidance& now) {
    return now.hindering > 1 ? LiveText::tr("%n other(s) hardly moved either.", nullptr, now.hindering - 1)
                             : QString();
}

LiveSentence ofMoving(const WizardRun& run, const QString& board, const QString& place, const Guidance& now) {
    const QString others = movingOthers(now);
    if (isWorn(run.task()))
        return {Tone::kNeutral, LiveText::tr("Wait: %1 still moves").arg(place),
                LiveText::tr("Stay in the rest pose and breathe calmly. %1").arg(others)};
    return {Tone::kNeutral, LiveText::tr("Wait: board %1 still moves").arg(board),
            LiveText::tr("Let go of it and wait until it lies still. %1").arg(others)};
}

LiveSentence ofBoards(const WizardRun& run, const Guidance& now) {
    const QString board = QString::number(now.board + 1);
    const QString place = boardName(run.suit().boards[static_cast<size_t>(now.board)], NameCase::kInside);
    switch (now.hindrance) {
        case Hindrance::kAbsent:
            return {
                Tone::kError, LiveText::tr("Board %1, %2, is silent").arg(board, place),
                LiveText::tr("Push its plug in until it clicks; if the light stays dark, change the cable. "
                             "Or skip it. %1")
                    .arg(silentOthers(now))};
        case Hindrance::kMoves:
            return ofMoving(run, board, place, now);
        case Hindrance::kIdle:
            return {Tone::kWarn, LiveText::tr("Once more: %1 hardly moved").arg(place),
                    LiveText::tr("Stand still in the rest pose, then: %1. %2")
                        .arg(run.stepWords(*now.step).instruction, idleOthers(now))};
        case Hindrance::kElsewhere:
            return {
                Tone::kWarn, LiveText::tr("Not yet: board %1 lies on another side").arg(board),
                LiveText::tr("Board %1, %2, is turned in its slot. Turn it as its neighbours are and press "
                             "it in. %3")
                    .arg(board, place, turnedOthers(now))};
        default:
            return {
                Tone::kWarn,
                LiveText::tr("Not yet: board %1 sits %2 askew in its slot").arg(board, askewText(now.value)),
                LiveText::tr("%n board(s) are level. Press board %1 into its slot until it clicks, then let "
                             "go of the plate.",
                             nullptr, now.right_boards)
                    .arg(board)};
    }
}

LiveSentence ofTurn(const Guidance& now) {
    switch (now.hindrance) {
        case Hindrance::kNotTurning:
            return {Tone::kNeutral, LiveText::tr("Start the table"),
                    LiveText::tr("33 1/3, 45 or 78 turns a minute, whichever it does best.")};
        case Hindrance::kUnevenTurn:
            return {Tone::kNeutral, LiveText::tr("Wait: %1 rpm").arg(rpmText(now.value)),
                    LiveText::tr("The table has not found its speed yet, or something makes it waver.")};
        case Hindrance::kTooFast:
            return {
                Tone::kError, LiveText::tr("Too fast: %1 rpm").arg(rpmText(now.value)),
                LiveText::tr("That is more than 80 % of what the gyroscope of board %1 can measure. Set the "
                             "table to a slower speed.")
                    .arg(now.board + 1)};
        default:
            return {
                Tone::kWarn, LiveText::tr("%1 rpm: wait").arg(rpmText(now.value)),
                LiveText::tr("That is none of the usual speeds, 33 1/3, 45 and 78. Set the table to one of "
                             "them.")};
    }
}

LiveSentence ofAll(const WizardRun& run, const Guidance& now) {
    switch (now.hindrance) {
        case Hindrance::kNoReadings:
            return {Tone::kError, LiveText::tr("No board is heard"),
                    LiveText::tr("Step Connect shows which board is missing and why.")};
        case Hindrance::kBetweenSteps:
            if (run.task() == WizardTask::kSources)
                return {
                    Tone::kNeutral, LiveText::tr("None of the measured placements is heard"),
                    LiveText::tr("The distances heard differ from all those in the file by more than 2 cm. "
                                 "Put boards and sources as they were measured.")};
            return {Tone::kNeutral, LiveText::tr("Turn the plate onto a side"),
                    LiveText::tr("It lies between two sides, or is in somebody’s hands.")};
        case Hindrance::kUnit:
            return {
                Tone::kError,
                LiveText::tr("The file’s distances are %1 times those heard")
                    .arg(numberText(now.value, now.value < 1     ? 3
                                               : now.value < 100 ? 1
                                                                 : 0)),
                LiveText::tr("Its numbers are in another unit than their heading says. Correct the heading "
                             "(x_m or x_mm, distance_m or distance_mm), leave and choose the file again.")};
        case Hindrance::kUnheard:
            return {Tone::kWarn, LiveText::tr("Only %1 of the pairs are heard").arg(percentText(now.value)),
                    LiveText::tr(
                        "Let boards and sources face each other, and take away what stands in between.")};
        case Hindrance::kStand:
            return {Tone::kNeutral,
                    LiveText::tr("Stand still for %1").arg(secondsText(std::ceil(now.value), 0)),
                    LiveText::tr(
                        "In the rest pose: arms a little away from the body, elbows slightly bent, palms "
                        "towards the body.")};
        case Hindrance::kMove:
            return {Tone::kOk, LiveText::tr("Move now"),
                    LiveText::tr("Smoothly and as far as is comfortable, until the ring is full.")};
        case Hindrance::kDone:
            return {Tone::kOk, LiveText::tr("%1 is done").arg(run.stepWords(*now.step).name),
                    LiveText::tr("Go on with what is asked above.")};
        default:
            return ofTurn(now);
    }
}

QString rightDetail(const WizardRun& run, const Guidance& now) {
    if (run.task() == WizardTask::kMovement)
        return LiveText::tr("Smoothly and as far as is comfortable.");
    if (isWorn(run.task()))
        return LiveText::tr("Stay like that, all boards are still.");
    if (run.task() == WizardTask::kGyroscopes)
        return LiveText::tr("%1 rpm, even. Nothing touches the table.").arg(rpmText(now.rpm.value_or(0)));
    return LiveText::tr("All %n board(s) are in place. Nothing touches them.", nullptr, now.asked_boards);
}

LiveMeasure levelness(const Guidance& now) {
    if (!now.worst_askew_rad)
        return {LiveText::tr("Plate level"), LiveText::tr("from the second side on"), 0, true};
    const double limit_rad = std::max(now.askew_limit_rad, SideGuide::kAskew_rad);
    return {LiveText::tr("Plate level"),
            LiveText::tr("%1, limit %2").arg(askewText(*now.worst_askew_rad), askewText(limit_rad)),
            *now.worst_askew_rad / limit_rad, *now.worst_askew_rad <= limit_rad};
}

LiveMeasure stillness(WizardTask task, const Guidance& now) {
    const double limit = isWorn(task) ? StandGuide::kSway_m_per_s2 : HealthSettings{}.still_accel_m_per_s2;
    const double deviation = now.worst_accel_deviation_m_per_s2;
    return {LiveText::tr("Still"),
            LiveText::tr("%1 m/s², limit %2").arg(numberText(deviation, 2), numberText(limit, 2)),
            deviation / limit, deviation <= limit};
}

/// What only this task looks at.
std::vector<LiveMeasure> ownMeasures(WizardTask task, const Guidance& now) {
    switch (task) {
        case WizardTask::kSources: {
            const double share = now.heard_share.value_or(0);
            return {{LiveText::tr("Pairs heard"), percentText(share), share,
                     share >= PlacementGuide::kEnoughShare}};
        }
        case WizardTask::kAccelerometers:
            return {levelness(now)};
        case WizardTask::kGyroscopes: {
            const double rpm = now.rpm.value_or(0);
            return {{LiveText::tr("Table"), LiveText::tr("%1 rpm").arg(rpmText(rpm)), std::abs(rpm) / 78,
                     rpm != 0}};
        }
        case WizardTask::kMovement:
            if (now.isRight())
                return {
                    {LiveText::tr("Movement"),
                     LiveText::tr("%1 of %2").arg(secondsText(now.held_s, 0), secondsText(holdOf(task), 1)),
                     now.held_s / holdOf(task), true}};
            return {};
        case WizardTask::kMagnetometers:
        case WizardTask::kRestPose:
        case WizardTask::kCheck:
            break;
    }
    return {};
}

}  // namespace

LiveSentence sentenceOf(const WizardRun& run) {
    if (run.phase() == WizardRun::Phase::kTaking)
        return {Tone::kOk, LiveText::tr("Taken"), LiveText::tr("It is being written to disk.")};
    if (run.isWaitingForSuit())
        return {Tone::kError, LiveText::tr("The suit has gone"),
                LiveText::tr("What has been taken is safe. It goes on when the driver box is back.")};
    if (!run.guide())
        return {};
    const Guidance& now = run.guide()->guidance();
    if (now.isRight()) {
        const double left_s = std::max(0.0, holdOf(run.task()) - now.held_s);
        const QString left = secondsText(std::ceil(left_s), 0);
        return {Tone::kOk,
                run.task() == WizardTask::kMovement ? LiveText::tr("Go on for %1").arg(left)
                                                    : LiveText::tr("Right. Hold it for %1").arg(left),
                rightDetail(run, now)};
    }
    return now.hindering > 0 && now.board >= 0 && now.hindrance != Hindrance::kTooFast ? ofBoards(run, now)
                                                                                       : ofAll(run, now);
}

std::vector<LiveMeasure> measuresOf(const WizardRun& run) {
    if (!run.guide())
        return {};
    const Guidance& now = run.guide()->guidance();
    std::vector<LiveMeasure> measures = ownMeasures(run.task(), now);
    if (run.task() != WizardTask::kMovement || !now.isRight())
        measures.push_back(stillness(run.task(), now));
    measures.push_back({LiveText::tr("Boards in place"),
                        LiveText::tr("%1 of %2").arg(now.right_boards).arg(now.asked_boards),
                        static_cast<double>(now.right_boards) / std::max(1, now.asked_boards),
                        now.right_boards == now.asked_boards});
    for (LiveMeasure& measure : measures) {
        measure.share = std::clamp(measure.share, 0.0, 1.0);
        if (now.boards.empty())  // nothing is seen: neither right nor wrong
            measure = {measure.name, kNoValue, 0, false};
    }
    return measures;
}

QString costOfSkipping(const WizardRun& run, int board) {
    const QString name = boardTitle(run.suit(), board);
    switch (run.task()) {
        case WizardTask::kSources:
            return LiveText::tr("%1 is left out: each offset rests on one board less.").arg(name);
        case WizardTask::kAccelerometers:
        case WizardTask::kGyroscopes:
        case WizardTask::kMagnetometers:
            return LiveText::tr("%1 is left out: it keeps the values it had before.").arg(name);
        case WizardTask::kRestPose:
        case WizardTask::kMovement:
        case WizardTask::kCheck:
            break;
    }
    return LiveText::tr("%1 is left out: how it sits today stays unknown.").arg(name);
}

}  // namespace noctule::ui
