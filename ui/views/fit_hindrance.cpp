// SPDX-License-Identifier: Apache-2.0
// The cards about the calibration and its check.
#include <QCoreApplication>

#include "ui/style/words.h"
#include "ui/views/fit_words.h"
#include "ui/views/readiness_words.h"

namespace noctule::ui {
namespace {

struct FitHindranceText {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ReadinessWords)
};

/// "26 hours"
QString hoursText(double hours) {
    const QDateTime now = QDateTime::currentDateTime();
    return ageText(now.addSecs(-static_cast<qint64>(hours * 3600)), now);
}

HindranceWords aboutStep(const ReadinessProblem& problem) {
    const QString name = stepName(*problem.step);
    HindranceWords words{{}, {}, FitHindranceText::tr("Calibrate"), "ruler", {}, Repair::kCalibrate};
    switch (problem.kind) {
        case ProblemKind::kStepNotUsable:
            words.title = FitHindranceText::tr("%1: the calibration is not usable").arg(name);
            words.text = FitHindranceText::tr(
                "It was saved all the same. Takes made with it are less exact than they could be, or wrong. "
                "Calibrate again.");
            break;
        case ProblemKind::kRestPoseOld:
            words.title =
                FitHindranceText::tr("The rest pose is %1 old", "an age").arg(hoursText(problem.value));
            words.text = FitHindranceText::tr(
                "The suit was probably put on anew since, and its boards sit otherwise. Calibrate the rest "
                "pose again, or check the suit if nobody took it off.");
            break;
        default:
            words.title = FitHindranceText::tr("%1: the calibration is %2 old", "an age")
                              .arg(name, hoursText(problem.value));
            words.text = problem.step == CalibrationStep::kSources
                             ? FitHindranceText::tr(
                                   "Offsets of sources hold for a year. Takes can be recorded all the same; "
                                   "calibrate when there is time.")
                             : FitHindranceText::tr(
                                   "Values of sensors hold for three months. Takes can be recorded all the "
                                   "same; calibrate when there is time.");
    }
    return words;
}

}  // namespace

HindranceWords fitHindrance(const ReadinessProblem& problem, const SuitCheck& check) {
    const CalibrationLack& lack = check.readiness().lack;
    const bool is_room = check.readiness().is_room;
    if (problem.kind == ProblemKind::kNotCalibrated)
        return {lack.isTotal() && !is_room
                    ? FitHindranceText::tr("The suit is not calibrated")
                    : FitHindranceText::tr("Without calibration of %1").arg(lackWords(lack)),
                is_room ? FitHindranceText::tr(
                              "Places of the anchors are found to decimetres only. Calibrate the "
                              "source offsets, or import the calibration of this box.")
                : lack.stopsTheBody()
                    ? FitHindranceText::tr(
                          "Takes can be recorded and processed once it is calibrated; until then "
                          "nobody sees whether they are good. Calibrate it, or import its "
                          "calibration.")
                    : FitHindranceText::tr(
                          "The body moves, less exactly than it could. Calibrate what is missing."),
                FitHindranceText::tr("Calibrate"),
                "ruler",
                {},
                Repair::kCalibrate};
    if (problem.step)
        return aboutStep(problem);
    const QDateTime rest_pose = check.restPoseMade();
    const QString age = rest_pose.isValid()
                            ? FitHindranceText::tr("The rest pose is from %1.").arg(dateInside(rest_pose))
                            : FitHindranceText::tr("It is not known when the rest pose was made.");
    const QString check_words = FitHindranceText::tr("Check the suit");
    if (problem.kind == ProblemKind::kMoved)
        return {
            FitHindranceText::tr("Something has moved since the calibration"),
            age + ' ' +
                FitHindranceText::tr("Put back what the check named and check again, or calibrate the rest "
                                     "pose again."),
            check_words,
            "rest_pose",
            {},
            Repair::kCheck};
    return {
        FitHindranceText::tr("Not checked since it was put on"),
        age + ' ' +
            FitHindranceText::tr("Hold still for three seconds: the check says whether boards sit in their "
                                 "places, slipped or were exchanged. Was the suit taken off since, calibrate "
                                 "the rest pose again."),
        check_words,
        "rest_pose",
        {},
        Repair::kCheck};
}

}  // namespace noctule::ui
