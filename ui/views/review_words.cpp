// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "core/math/conventions.h"
#include "ui/models/part_names.h"
#include "ui/scene/scene_words.h"
#include "ui/style/words.h"
#include "ui/views/fit_words.h"

namespace noctule::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ReviewWords)
};

QString sensorsInWords(const std::string& sensors) {
    if (sensors == "AGD")
        return Words::tr("All sensors");
    if (sensors == "AG")
        return Words::tr("Without distances");
    if (sensors == "AD")
        return Words::tr("Without gyroscopes");
    if (sensors == "GD")
        return Words::tr("Without accelerometers");
    if (sensors == "A")
        return Words::tr("Accelerometers only");
    if (sensors == "G")
        return Words::tr("Gyroscopes only");
    if (sensors == "D")
        return Words::tr("Distances only");
    return Words::tr("No sensors");
}

constexpr double kWholeTake = 0.95;  ///< share of it; references begin and end a moment apart

double radiansOf(double value_deg) {
    return radians(value_deg);
}

const VerdictJoint* jointOf(const TakeVerdict& verdict, const std::string& name) {
    const auto found = std::find_if(verdict.joints.begin(), verdict.joints.end(),
                                    [&](const VerdictJoint& joint) { return joint.joint == name; });
    return found == verdict.joints.end() ? nullptr : &*found;
}

ProblemWords jointProblem(const TakeVerdict& verdict) {
    const VerdictJoint* joint = jointOf(verdict, verdict.worst_joint);
    const QString title = jointName(verdict.worst_joint);
    ProblemWords words;
    words.joint = QString::fromStdString(verdict.worst_joint);
    words.action = Words::tr("Show %1").arg(jointName(verdict.worst_joint, NameCase::kInside));
    words.time_s = verdict.worst_from_s.value_or(-1);
    words.title = Words::tr("%1 is off by %2")
                      .arg(title, degreesText(radiansOf(joint ? joint->mean_deg.value_or(0) : 0)));
    words.text = verdict.worst_from_s
                     ? Words::tr(
                           "Most of it after %1. Check whether the strap moved there; with in and out set "
                           "around the good part the take stays usable.")
                           .arg(timeText(*verdict.worst_from_s, 0))
                     : Words::tr("It is off throughout. Check on the performer page where its boards sit.");
    return words;
}

/// No joint stands out from the others.
ProblemWords supportOfAll(const TakeVerdict& verdict, const TakeOverview& overview) {
    const QString drift =
        Words::tr("Without ranges a joint follows its gyroscope, which drifts by 1 to 3° a minute.");
    ProblemWords words;
    if (overview.suit.sources.empty()) {
        words.title = Words::tr("The suit has no sources");
        words.text = Words::tr("How far its joints drift is not known without a reference.");
    } else if (verdict.backed_share <= 0) {
        words.title = Words::tr("No joint was backed by ranges");
        words.text = drift;
    } else {
        words.title =
            Words::tr("Ranges backed the joints only %1 of the time").arg(percentText(verdict.backed_share));
        words.text = drift + ' ' + Words::tr("Look at the pairs for sources or boards that were not heard.");
    }
    return words;
}

/// No sensor told of it.
ProblemWords aloneProblem(const TakeVerdict& verdict) {
    ProblemWords words;
    words.joint = QString::fromStdString(verdict.alone_joint);
    words.action = Words::tr("Show %1").arg(jointName(verdict.alone_joint, NameCase::kInside));
    words.title = verdict.alone_by_design
                      ? Words::tr("%1 has no sensor").arg(jointName(verdict.alone_joint))
                      : Words::tr("%1 was told by no sensor for %2 of the time")
                            .arg(jointName(verdict.alone_joint), percentText(verdict.alone_share));
    words.text =
        Words::tr("It keeps its usual pose meanwhile. A board on it, or on what it carries, tells it.");
    return words;
}

ProblemWords supportProblem(const TakeVerdict& verdict, const TakeOverview& overview) {
    if (!verdict.alone_joint.empty())
        return aloneProblem(verdict);
    if (verdict.worst_joint.empty())
        return supportOfAll(verdict, overview);
    const VerdictJoint* joint = jointOf(verdict, verdict.worst_joint);
    ProblemWords words;
    words.joint = QString::fromStdString(verdict.worst_joint);
    words.action = Words::tr("Show %1").arg(jointName(verdict.worst_joint, NameCase::kInside));
    words.time_s = verdict.worst_from_s.value_or(-1);
    words.title = Words::tr("%1 is less certain").arg(jointName(verdict.worst_joint));
    const QString share = percentText(joint ? joint->backed_by_ranges : 0);
    words.text = verdict.worst_from_s
                     ? Words::tr(
                           "Ranges backed it %1 of the time, least from %2 on. In between it follows its "
                           "gyroscope, which drifts by 1 to 3° a minute.")
                           .arg(share, timeText(*verdict.worst_from_s, 0))
                     : Words::tr(
                           "Ranges backed it %1 of the time. In between it follows its gyroscope, which "
                           "drifts by 1 to 3° a minute.")
                           .arg(share);
    return words;
}

ProblemWords boardProblem(const TakeVerdict& verdict, const TakeOverview& overview) {
    ProblemWords words;
    if (verdict.lossy_boards.empty())
        return words;
    const VerdictBoard& worst = verdict.lossy_boards.front();
    if (verdict.lost_together) {
        words.title = Words::tr("All boards lost %1 of their frames").arg(percentText(worst.lost_share));
        words.text = Words::tr(
            "They lost them together: the link to the driver box broke off or was too slow. Check its cable "
            "or network before the next take.");
        return words;
    }
    words.board = worst.board;
    words.action = Words::tr("Show this board");
    if (worst.joined_s || worst.left_s) {
        const QString board = boardTitle(overview.suit, worst.board);
        words.title = worst.joined_s ? Words::tr("%1 joined at %2").arg(board, timeText(*worst.joined_s, 0))
                                     : Words::tr("%1 left at %2").arg(board, timeText(*worst.left_s, 0));
        words.text = Words::tr(
            "Its neighbours carry it while it is not there. See that all boards deliver before the next take "
            "begins.");
        return words;
    }
    words.title = Words::tr("%1 lost %2 of its frames")
                      .arg(boardTitle(overview.suit, worst.board), percentText(worst.lost_share));
    const int others = static_cast<int>(verdict.lossy_boards.size()) - 1;
    words.text = others > 0 ? Words::tr(
                                  "%n other boards lost some too. Their neighbours carry them meanwhile; "
                                  "check plugs and cables before the next take.",
                                  nullptr, others)
                            : Words::tr(
                                  "Its neighbours carry it meanwhile. Check its plug and cable before the "
                                  "next take.");
    return words;
}

ProblemWords residualProblem(const TakeVerdict& verdict, const TakeOverview& overview) {
    ProblemWords words;
    // One cause, one warning: what has no calibration sits nowhere else than it says.
    const bool is_calibrated = std::ranges::count(verdict.reasons, VerdictReason::kNotCalibrated) == 0;
    if (!verdict.astray) {
        words.title = Words::tr("A third of the ranges miss the pose by more than %1")
                          .arg(millimetresText(verdict.residual_spread_m.value_or(0)));
        words.text = !is_calibrated
                         ? Words::tr("Calibrate what is missing first.")
                         : Words::tr(
                               "A board or a source may sit elsewhere than the performer page says, or the "
                               "source offsets are another box's. Check both, then reprocess.");
        return words;
    }
    const VerdictPart& part = *verdict.astray;
    words.title = Words::tr("%1: half of its ranges miss the pose by more than %2")
                      .arg(part.is_source ? sourceTitle(overview.suit, part.index)
                                          : boardTitle(overview.suit, part.index),
                           millimetresText(part.median_m));
    words.text = !is_calibrated ? Words::tr("Calibrate what is missing first.")
                                : Words::tr(
                                      "It may sit elsewhere than the performer page says, or point elsewhere "
                                      "than when it was calibrated. "
                                      "Check it, then reprocess.");
    if (!part.is_source) {
        words.board = part.index;
        words.action = Words::tr("Show this board");
    }
    return words;
}

ProblemWords lackProblem(const TakeVerdict& verdict) {
    ProblemWords words;
    words.title = verdict.lack.isTotal()
                      ? Words::tr("This take has no calibration")
                      : Words::tr("Without calibration of %1").arg(lackWords(verdict.lack));
    words.text = Words::tr(
        "The recording itself is whole. Calibrate the suit or find the calibration of that day, then process "
        "the take with it.");
    words.action = Words::tr("Process with a calibration");
    words.processes = true;
    return words;
}

ProblemWords gyroscopesProblem(const TakeVerdict& verdict) {
    ProblemWords words;
    words.title = verdict.sensors == "D"   ? Words::tr("Made of distances only")
                  : verdict.sensors == "A" ? Words::tr("Made of accelerometers only")
                                           : Words::tr("Made without gyroscopes");
    words.text = Words::tr(
        "No gyroscope was used, so the angles are guesses. Process the take with gyroscopes for a result to "
        "work with.");
    words.action = Words::tr("Process with gyroscopes");
    words.processes = words.with_gyroscopes = true;
    return words;
}

ProblemWords lostInRestProblem(const TakeOverview& overview) {
    const TakeParty* party = overview.partyOf(overview.suit_in_view);
    const QString name = QString::fromStdString(party ? party->subject.name : overview.performer);
    const double at_s = party ? party->lost_in_rest_s.value_or(overview.duration_s) : overview.duration_s;
    ProblemWords words;
    const LostWords lost = lostInRest(name, at_s);
    words.title = lost.what;
    words.text = lost.consequence;
    return words;
}

}  // namespace

QString runInWords(const RunSettings& settings) {
    QStringList parts;
    const QString sensors = sensorsInWords(settings.sensors);
    if (settings.estimator == "paper") {
        parts += Words::tr("Published filter");
        if (settings.sensors != "AGD")
            parts += sensors.left(1).toLower() + sensors.mid(1);
    } else if (settings.estimator == "orientation") {
        parts += Words::tr("Independent sensors");
    } else {
        parts += sensors;
    }
    if (!settings.smoother.empty() && settings.smoother != "none")
        parts += Words::tr("smoothed");
    return parts.join(Words::tr(", "));
}

QString runTitle(const ReviewRun& run) {
    // As defaultRunName() and its numbering make them.
    static const QRegularExpression kMadeUp(
        "^[AGD]+( paper| manifold| orientation)?( smoothed| lag| batch)?( (\\d+))?$");
    const QString name = QString::fromStdString(run.run.name);
    const auto match = kMadeUp.match(name);
    if (!match.hasMatch() && !name.isEmpty())
        return name;
    const QString number = match.captured(4), words = runInWords(run.settings);
    return number.isEmpty() ? words : Words::tr("%1 (%2)").arg(words, number);
}

QString numberedTitle(const ReviewRun& run) {
    return QStringLiteral("%1: %2").arg(QString::number(run.number), runTitle(run));
}

QString peopleInWords(const ReviewRun& run) {
    QStringList names, unjoined;
    for (const TakeSubject& subject : subjectsOf(run.run)) {
        names += QString::fromStdString(subject.name);
        if (std::ranges::count(run.settings.unjoined, subject.suit()) > 0)
            unjoined += names.back();
    }
    if (names.size() < 2)
        return {};
    const QString people = names.join(Words::tr(", "));
    if (run.settings.root_given)
        return Words::tr("%1: each alone, placed by another system").arg(people);
    if (!run.settings.between && !run.settings.uses_room)
        return Words::tr("%1: each alone, without ranges between them").arg(people);
    const QString how = (run.settings.between && run.settings.uses_room
                             ? Words::tr("%1: together, with ranges between them and to the room")
                         : run.settings.between ? Words::tr("%1: together, with ranges between them")
                                                : Words::tr("%1: together, with ranges to the room"))
                            .arg(people);
    return unjoined.isEmpty()
               ? how
               : Words::tr("%1; could not be joined: %2").arg(how, unjoined.join(Words::tr(", ")));
}

Tone toneOf(Grade grade) {
    return grade == Grade::kGood ? Tone::kOk : grade == Grade::kUsable ? Tone::kWarn : Tone::kError;
}

QString gradeInWords(Grade grade) {
    switch (grade) {
        case Grade::kGood:
            return Words::tr("Good take");
        case Grade::kUsable:
            return Words::tr("Usable take");
        case Grade::kNotUsable:
        case Grade::kUnknown:
            break;
    }
    return Words::tr("Not usable");
}

QString gradeExplained(const TakeVerdict& verdict) {
    if (verdict.grade == Grade::kNotUsable)
        return verdict.lack.stopsTheBody()
                   ? takeLackSentence(verdict.lack)
                   : Words::tr("Better not used as it is. Why, and what may help, is told below.");
    if (verdict.grade == Grade::kUsable)
        return Words::tr("Good enough to work with. What to look at first is told below.");
    if (verdict.mean_error_deg)
        return verdict.compared_share < kWholeTake
                   ? Words::tr("It follows the reference, which covers %1 of it.")
                         .arg(percentText(verdict.compared_share))
                   : Words::tr("It follows the reference from start to end.");
    return Words::
        tr("Ranges backed the joints %1 of the time, and inertia carried them in between; none stands out.")
            .arg(percentText(verdict.backed_share));
}

std::vector<ProblemWords> problemsInWords(const TakeVerdict& verdict, const TakeOverview& overview) {
    std::vector<ProblemWords> problems;
    for (const VerdictReason reason : verdict.reasons) {
        ProblemWords words;
        switch (reason) {
            case VerdictReason::kNone:
                continue;
            case VerdictReason::kMeanError:
                words.title = Words::tr("The mean joint error is %1")
                                  .arg(degreesText(radiansOf(verdict.mean_error_deg.value_or(0))));
                words.text =
                    Words::tr(
                        "Good takes stay under %1 against their reference. Another choice of sensors or a "
                        "newer calibration may bring it down: reprocess and compare.")
                        .arg(degreesText(radiansOf(VerdictLimits{}.good_mean_deg), 0));
                break;
            case VerdictReason::kJointError:
                words = jointProblem(verdict);
                break;
            case VerdictReason::kSupport:
                words = supportProblem(verdict, overview);
                break;
            case VerdictReason::kNotCalibrated:
                words = lackProblem(verdict);
                break;
            case VerdictReason::kNoGyroscopes:
                words = gyroscopesProblem(verdict);
                break;
            case VerdictReason::kResidual:
                words = residualProblem(verdict, overview);
                break;
            case VerdictReason::kDistances:
                words.title = Words::tr("Most distances cannot be used");
                words.text = Words::tr(
                    "They lie below 0 or beyond 20 m, or miss the pose by far. Check the unit of recordings "
                    "from elsewhere, else source offsets and places of boards.");
                break;
            case VerdictReason::kBoardLost:
                words = boardProblem(verdict, overview);
                break;
            case VerdictReason::kHole:
                words.title =
                    Words::tr("No signal for %1 in one piece").arg(secondsText(verdict.longest_hole_s, 2));
                words.text = Words::tr(
                    "The pose is a guess there. The timeline hatches these gaps; keep them outside "
                    "in and out.");
                break;
            case VerdictReason::kPeopleApart:
                words.title = Words::tr("Where they stand to each other is not known");
                words.text = Words::tr(
                    "No ranges between all performers or to a room were used: distances between them mean "
                    "nothing. "
                    "See that every suit has a calibration and heard the others, and process with all "
                    "sensors.");
                break;
            case VerdictReason::kEndsInRest:
                words = lostInRestProblem(overview);
                break;
            case VerdictReason::kNoPoses:
                words.title = Words::tr("This result shows no pose");
                words.text = Words::tr(
                    "The filter found nothing to start from. Reprocess with all sensors, or look "
                    "whether the take holds sound at all.");
                break;
        }
        words.tone = verdict.grade == Grade::kNotUsable && problems.empty() ? Tone::kError : Tone::kWarn;
        problems.push_back(words);
    }
    return problems;
}

}  // namespace noctule::ui
