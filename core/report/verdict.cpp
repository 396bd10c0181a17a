// SPDX-License-Identifier: Apache-2.0
#include "core/report/verdict.h"

#include <algorithm>
#include <cmath>

#include "core/body/text.h"
#include "core/report/range_statistics.h"
#include "core/report/sections.h"
#include "core/report/take_verdict.h"

namespace noctule {
namespace {

std::string referenceName(const ReportTake& take) {
    if (take.reference_kind == "simulated")
        return "the simulated truth";
    if (take.reference_kind.empty())
        return "the reference";
    return "the " + take.reference_kind + " reference";
}

constexpr const char* kDrift =
    "Without ranges a joint follows its gyroscope, which drifts by 1 to 3° a minute.";

/// "Left shoulder (LeftArm)": as people say it, and as tables and exports have it.
std::string bothNames(const std::string& joint) {
    const std::string label = text::jointLabel(joint);
    return label == joint ? label : label + " (" + joint + ")";
}

std::string jointSentence(const Comparison& comparison, const std::string& worst) {
    const double limit_deg = VerdictLimits{}.good_joint_deg;
    const auto bad = std::ranges::count_if(
        comparison.joints, [&](const JointComparison& joint) { return joint.angle.mean_deg > limit_deg; });
    return text::plural(bad, "joint is", "joints are") + " more than " + text::degrees(limit_deg, 0) +
           " off on average, worst " + bothNames(worst) + " with " +
           text::degrees(comparison.find(worst)->angle.mean_deg) + ".";
}

std::string supportSentence(const ReportData& data, const TakeVerdict& judged) {
    if (judged.alone_by_design)
        return bothNames(judged.alone_joint) + " has no sensor and keeps its usual pose.";
    if (!judged.alone_joint.empty())
        return bothNames(judged.alone_joint) + " was told by no sensor for " +
               text::percent(judged.alone_share) + " of the time.";
    if (judged.worst_from_s)
        return bothNames(judged.worst_joint) + " is less certain from " + text::clock(*judged.worst_from_s) +
               " on: ranges stopped backing it. " + kDrift;
    if (data.sources.empty())
        return "The suit has no sources. How far its joints drift is not known without a reference.";
    if (judged.backed_share <= 0)
        return std::string("No joint was backed by ranges. ") + kDrift;
    return "Ranges backed the joints only " + text::percent(judged.backed_share) + " of the time. " + kDrift;
}

std::string residualSentence(const ReportData& data, const TakeVerdict& judged) {
    const auto millimetres = [](double value_m) { return text::number(1000 * value_m, 0) + " mm"; };
    // One cause, one warning: of a part without calibration nothing else is to blame.
    const bool is_calibrated = std::ranges::count(judged.reasons, VerdictReason::kNotCalibrated) == 0;
    if (!judged.astray) {
        const std::string miss = "A third of the ranges miss the pose by more than " +
                                 millimetres(judged.residual_spread_m.value_or(0));
        return is_calibrated ? miss +
                                   ": a board or a source sits elsewhere than its calibration says, or the "
                                   "source offsets are another box's."
                             : miss + ". Calibrate what is missing first.";
    }
    const VerdictPart& part = *judged.astray;
    const std::string miss =
        text::capitalised(part.is_source ? sourceLabel(data, part.index) : boardLabel(data, part.index)) +
        ": half of its ranges miss the pose by more than " + millimetres(part.median_m);
    return is_calibrated ? miss + ". It sits or points elsewhere than when it was calibrated."
                         : miss + ". Calibrate what is missing first.";
}

std::string apartSentence(const ReportData& data) {
    if (data.unjoined.empty())
        return "Nothing measured where the performers stand to each other: no ranges between them or to a "
               "room "
               "were used. Distances between them mean nothing.";
    std::string names;
    for (const std::string& name : data.unjoined)
        names += (names.empty() ? "" : ", ") + name;
    return "Not measured where they stand to the others: " + names +
           ". Too few ranges fit while the rest pose was held. Distances to them mean nothing.";
}

/// Empty: the headline or a note says it.
std::string reasonSentence(VerdictReason reason, const ReportData& data, const ReportRun& run,
                           const TakeVerdict& judged) {
    switch (reason) {
        case VerdictReason::kJointError:
            return jointSentence(*run.comparison, judged.worst_joint);
        case VerdictReason::kSupport:
            return supportSentence(data, judged);
        case VerdictReason::kResidual:
            return residualSentence(data, judged);
        case VerdictReason::kDistances:
            return judged.refused_share > VerdictLimits{}.good_refused
                       ? text::percent(judged.refused_share) +
                             " of the take's distances cannot be: they lie below 0 or beyond 20 m. Give "
                             "them in metres."
                       : "";
        case VerdictReason::kHole:
            return "No signal for " + text::number(judged.longest_hole_s, 2) +
                   " s in one piece: the pose is a guess there.";
        case VerdictReason::kPeopleApart:
            return apartSentence(data);
        case VerdictReason::kNoGyroscopes:
            return "Made of " + sensorsInWords(run.sensors) +
                   ": no gyroscope was used, so the angles are guesses. Process the take with gyroscopes for "
                   "a "
                   "result to work with.";
        case VerdictReason::kNone:
        case VerdictReason::kMeanError:
        case VerdictReason::kBoardLost:
        case VerdictReason::kNoPoses:
        case VerdictReason::kEndsInRest:
        case VerdictReason::kNotCalibrated:
            break;
    }
    return {};
}

/// Without calibration a filter is too sure of itself: that is no second fault.
void judgeConsistency(const Comparison& comparison, bool lacks_calibration, Verdict& verdict) {
    if (comparison.nees && *comparison.nees > 3 && !lacks_calibration)
        verdict.reasons.push_back("The filter is too sure of itself: its errors are " +
                                  text::number(std::sqrt(*comparison.nees), 1) +
                                  " times as large as it says (NEES " + text::number(comparison.nees, 1) +
                                  " instead of 1).");
    if (comparison.unmatched > 0)
        verdict.reasons.push_back(text::count(comparison.unmatched) +
                                  " frames could not be compared because the reference has none near them.");
    if (comparison.refused_offset)
        verdict.reasons.push_back(
            "The clocks of take and reference were not aligned: the reference's motion " +
            distrust(*comparison.refused_offset) + ". Check that the reference shows this take.");
}

/// Empty: it came and went with the take.
std::string presenceSentence(const std::string& name, const std::optional<double>& joined_s,
                             const std::optional<double>& left_s) {
    if (joined_s && left_s)
        return name + "joined at " + text::clock(*joined_s) + " and left at " + text::clock(*left_s) + ".";
    if (joined_s)
        return name + "joined at " + text::clock(*joined_s) + ".";
    return left_s ? name + "left at " + text::clock(*left_s) + "." : "";
}

/// Empty: it lost little while it was there.
std::string lossSentence(const ReportBoard& board, const std::string& name) {
    if (board.lostShareWhileThere() > VerdictLimits{}.good_lost)
        return name + "lost " + text::percent(board.lostShareWhileThere()) +
               " of its frames. Check its plug and cable.";
    if (board.frames_absent == 0 && board.readingShare() < kGoodReadings)
        return name + "delivered " + text::percent(board.readingShare()) +
               " of its readings. Check its plug and cable.";
    return {};
}

struct Presence {
    std::optional<double> joined_s, left_s;
};

/// Of all boards that came late or left early together: the box did.
Presence suitPresence(const ReportData& data) {
    constexpr double kTogether_s = 1;
    const auto isTogether = [&](std::optional<double> ReportBoard::*when_s) {
        const auto& first_s = data.boards.front().*when_s;
        return first_s && std::ranges::all_of(data.boards, [&](const ReportBoard& board) {
                   return board.*when_s && std::abs(*(board.*when_s) - *first_s) < kTogether_s;
               });
    };
    if (data.boards.empty())
        return {};
    const auto whenTogether = [&](std::optional<double> ReportBoard::*when_s) {
        return isTogether(when_s) ? data.boards.front().*when_s : std::nullopt;
    };
    return {whenTogether(&ReportBoard::joined_s), whenTogether(&ReportBoard::left_s)};
}

void judgeBoards(const ReportData& data, const TakeVerdict& judged, Verdict& verdict) {
    if (judged.lost_together)
        verdict.reasons.push_back("All boards lost " + text::percent(judged.lossy_boards.front().lost_share) +
                                  " of their frames together: the link to the driver box broke off or was "
                                  "too slow. Check its cable or network.");
    const auto sayPresence = [&](const std::string& name, const Presence& there) {
        if (std::string sentence = presenceSentence(name, there.joined_s, there.left_s); !sentence.empty())
            verdict.reasons.push_back(std::move(sentence));
    };
    const Presence suit = suitPresence(data);
    sayPresence("All boards ", suit);
    for (size_t i = 0; i < data.boards.size(); ++i) {
        const ReportBoard& board = data.boards[i];
        const std::string name = text::capitalised(boardLabel(data, static_cast<int>(i))) + " ";
        if (board.frames_absent > 0)
            sayPresence(name, {suit.joined_s ? std::nullopt : board.joined_s,
                               suit.left_s ? std::nullopt : board.left_s});
        if (const std::string loss = lossSentence(board, name); !loss.empty() && !judged.lost_together)
            verdict.reasons.push_back(loss);
        if (board.clipped_gyro + board.clipped_accel > 0)
            verdict.reasons.push_back(
                name + "was clipped in " +
                text::plural(board.clipped_gyro + board.clipped_accel, "reading", "readings") +
                ": the motion was faster than its range.");
    }
}

void judgeRanges(const ReportData& data, Verdict& verdict) {
    const RangeStatistics ranges = rangeStatistics(data.pairs);
    const int64_t tried = ranges.of(PulseFate::kUsed) + ranges.of(PulseFate::kRejected);
    const double rejected =
        tried > 0 ? static_cast<double>(ranges.of(PulseFate::kRejected)) / static_cast<double>(tried) : 0;
    if (rejected > kManyRejected)
        verdict.reasons.push_back("The filter rejected " + text::percent(rejected) +
                                  " of the ranges it tried: a wrong source offset, a board out of place or a "
                                  "pose that has been lost.");
}

}  // namespace

std::string gradeName(Grade grade) {
    return text::capitalised(gradeWord(grade));
}

Verdict judge(const ReportData& data) {
    const ReportRun* run = data.shownRun();
    if (!run)
        return {Grade::kUnknown, "Not processed yet. The take holds no result to judge.", data.warnings};
    const TakeVerdict judged = judgeTake(data);
    Verdict verdict{judged.grade, {}, {}};
    if (data.take.ends_in_rest) {
        verdict.headline =
            gradeName(verdict.grade) + ". The recording ends before the rest pose does. There is no motion.";
        verdict.reasons = data.warnings;
        return verdict;
    }
    const bool is_uncalibrated =
        judged.grade == Grade::kNotUsable && judged.reasons.front() == VerdictReason::kNotCalibrated;
    if (run->comparison)
        verdict.headline = gradeName(verdict.grade) + ". Mean joint error " +
                           text::degrees(run->comparison->mean_deg) + " against " + referenceName(data.take) +
                           ".";
    else if (is_uncalibrated)
        verdict.headline = gradeName(verdict.grade) + ": " + lackClause(data.lack);
    else
        verdict.headline =
            gradeName(verdict.grade) + ". Without a reference the error of this take is not known.";
    for (const VerdictReason reason : judged.reasons)
        if (std::string sentence = reasonSentence(reason, data, *run, judged); !sentence.empty())
            verdict.reasons.push_back(std::move(sentence));
    const bool lacks_calibration = gradeOf(data.lack, run->sensors) != Grade::kGood;
    if (run->comparison)
        judgeConsistency(*run->comparison, lacks_calibration, verdict);
    if (lacks_calibration && !is_uncalibrated)
        verdict.reasons.push_back(lackSentence(data.lack));
    if (!lacks_calibration &&
        run->sensors.find('G') != std::string::npos)  // else rejected ranges follow from it
        judgeRanges(data, verdict);
    judgeBoards(data, judged, verdict);
    verdict.reasons.insert(verdict.reasons.end(), data.warnings.begin(), data.warnings.end());
    return verdict;
}

const ReportRun* ReportData::shownRun() const {
    const auto shown = std::find_if(runs.begin(), runs.end(), [](const ReportRun& r) { return r.is_shown; });
    if (shown != runs.end())
        return &*shown;
    return runs.empty() ? nullptr : &runs.back();
}

}  // namespace noctule
