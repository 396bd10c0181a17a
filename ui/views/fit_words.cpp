// SPDX-License-Identifier: Apache-2.0
#include "ui/views/fit_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace noctule::ui {
namespace {

struct FitText {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::FitWords)
};

bool has(const Readiness& readiness, ProblemKind kind) {
    return std::ranges::find(readiness.problems, kind, &ReadinessProblem::kind) != readiness.problems.end();
}

bool isOfAll(const std::vector<int>& parts, int all) {
    return static_cast<int>(parts.size()) == all;
}

int count(const std::vector<int>& parts) {
    return static_cast<int>(parts.size());
}

}  // namespace

QString lackWords(const CalibrationLack& lack) {
    QStringList words;
    if (!lack.sources.empty())
        words << (isOfAll(lack.sources, lack.source_count)
                      ? FitText::tr("the source offsets")
                      : FitText::tr("the offsets of %n source(s)", nullptr, count(lack.sources)));
    if (!lack.accelerometers.empty())
        words << (isOfAll(lack.accelerometers, lack.board_count)
                      ? FitText::tr("the accelerometers")
                      : FitText::tr("the accelerometers of %n board(s)", nullptr,
                                    count(lack.accelerometers)));
    if (!lack.gyroscopes.empty())
        words << (isOfAll(lack.gyroscopes, lack.board_count)
                      ? FitText::tr("the gyroscopes")
                      : FitText::tr("the gyroscopes of %n board(s)", nullptr, count(lack.gyroscopes)));
    if (!lack.rest_pose.empty())
        words << (isOfAll(lack.rest_pose, lack.board_count)
                      ? FitText::tr("the rest pose")
                      : FitText::tr("the rest pose of %n board(s)", nullptr, count(lack.rest_pose)));
    if (words.size() < 2)
        return words.join(QString());
    const QString last = words.takeLast();
    return FitText::tr("%1 and %2", "a list and its last part").arg(words.join(FitText::tr(", ")), last);
}

QString stepName(CalibrationStep step) {
    switch (step) {
        case CalibrationStep::kSources:
            return FitText::tr("Source offsets");
        case CalibrationStep::kAccelerometers:
            return FitText::tr("Accelerometers");
        case CalibrationStep::kGyroscopes:
            return FitText::tr("Gyroscopes");
        case CalibrationStep::kMagnetometers:
            return FitText::tr("Magnetometers");
        case CalibrationStep::kRestPose:
            return FitText::tr("Rest pose");
        case CalibrationStep::kMovement:
            break;
    }
    return FitText::tr("Movement");
}

QString takeLackSentence(const CalibrationLack& lack) {
    if (lack.isNone())
        return {};
    if (lack.isTotal())
        return FitText::tr("This take has no calibration. Process it with one.");
    return FitText::tr("This take was made without calibration of %1. Process it with one that has them.")
        .arg(lackWords(lack));
}

QString whyNotCheck(const CalibrationLack& lack) {
    if (isOfAll(lack.rest_pose, lack.board_count) && lack.board_count > 0 && !lack.ofMostGyroscopes())
        return FitText::tr("Cannot be checked: the rest pose is not calibrated.");
    if (lack.ofMostGyroscopes())
        return FitText::tr("Cannot be checked: gyroscopes are not calibrated.");
    return {};
}

QString fitSentence(const Readiness& readiness) {
    const CalibrationLack& lack = readiness.lack;
    if (has(readiness, ProblemKind::kNotCalibrated)) {
        if (readiness.is_room)
            return FitText::tr(
                       "Without calibration of %1: places of the anchors are found to decimetres only.")
                .arg(lackWords(lack));
        if (lack.isTotal())
            return FitText::tr("Not calibrated: the body cannot move yet.");
        return lack.stopsTheBody()
                   ? FitText::tr("Without calibration of %1: the body cannot move yet.").arg(lackWords(lack))
                   : FitText::tr("Without calibration of %1.").arg(lackWords(lack));
    }
    if (has(readiness, ProblemKind::kStepNotUsable))
        return FitText::tr("Part of the calibration is not usable.");
    if (has(readiness, ProblemKind::kMoved))
        return FitText::tr("The check found that something has moved.");
    if (has(readiness, ProblemKind::kRestPoseOld))
        return FitText::tr("The rest pose is old.");
    if (has(readiness, ProblemKind::kNotChecked))
        return FitText::tr("Not checked since it was put on.");
    if (has(readiness, ProblemKind::kStepOld))
        return FitText::tr("Part of the calibration is due again.");
    return {};
}

QString recordingWords(const Readiness& readiness) {
    if (has(readiness, ProblemKind::kNotCalibrated))
        return readiness.lack.isTotal()
                   ? FitText::tr("Recording, without calibration")
                   : FitText::tr("Recording, without calibration of %1").arg(lackWords(readiness.lack));
    if (has(readiness, ProblemKind::kStepNotUsable))
        return FitText::tr("Recording, with a calibration that is not usable");
    if (has(readiness, ProblemKind::kMoved))
        return FitText::tr("Recording, though something has moved");
    if (has(readiness, ProblemKind::kRestPoseOld))
        return FitText::tr("Recording, with an old rest pose");
    if (has(readiness, ProblemKind::kNotChecked))
        return FitText::tr("Recording, not checked");
    if (has(readiness, ProblemKind::kStepOld))
        return FitText::tr("Recording, with an old calibration");
    return FitText::tr("Recording well");
}

}  // namespace noctule::ui
