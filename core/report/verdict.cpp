// SPDX-License-Identifier: Apache-2.0
#include "core/report/verdict.h"

#include <algorithm>

#include "core/body/text.h"
#include "core/report/range_statistics.h"
#include "core/report/sections.h"

namespace noctule {
namespace {

std::string referenceName(const ReportTake& take) {
    if (take.reference_kind == "simulated")
        return "the simulated truth";
    if (take.reference_kind.empty())
        return "the reference";
    return "the " + take.reference_kind + " reference";
}

void lower(Verdict& verdict, Grade grade) {
    verdict.grade = std::max(verdict.grade, grade);
}

void judgeJoints(const Comparison& comparison, Verdict& verdict) {
    std::vector<const JointComparison*> bad;
    for (const JointComparison& joint : comparison.joints)
        if (joint.angle.mean_deg > kGoodJoint_deg)
            bad.push_back(&joint);
    if (bad.empty())
        return;
    lower(verdict, Grade::kUsable);
    const auto worst = *std::max_element(bad.begin(), bad.end(), [](const auto* a, const auto* b) {
        return a->angle.mean_deg < b->angle.mean_deg;
    });
    verdict.reasons.push_back(text::plural(static_cast<int64_t>(bad.size()), "joint is", "joints are") +
                              " more than " + text::degrees(kGoodJoint_deg, 0) + " off on average, worst " +
                              text::jointLabel(worst->name) + " with " +
                              text::degrees(worst->angle.mean_deg) + ".");
}

void judgeConsistency(const Comparison& comparison, Verdict& verdict) {
    if (comparison.nees && *comparison.nees > 3)
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

void judgeBoards(const ReportData& data, Verdict& verdict) {
    for (size_t i = 0; i < data.boards.size(); ++i) {
        const ReportBoard& board = data.boards[i];
        if (board.readings_expected <= 0)
            continue;
        const double share =
            static_cast<double>(board.readings_present) / static_cast<double>(board.readings_expected);
        const std::string name = text::capitalised(boardLabel(data, static_cast<int>(i))) + " ";
        if (share < kUsableReadings)
            lower(verdict, Grade::kUsable);
        if (share < kGoodReadings)
            verdict.reasons.push_back(name + "delivered " + text::percent(share) +
                                      " of its readings. Check its plug and cable.");
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
    Verdict verdict{Grade::kGood, {}, {}};
    const ReportRun* run = data.shownRun();
    const Comparison* comparison = run && run->comparison ? &*run->comparison : nullptr;
    if (comparison) {
        if (!(comparison->mean_deg <= kGoodMean_deg))
            lower(verdict, comparison->mean_deg <= kUsableMean_deg ? Grade::kUsable : Grade::kNotUsable);
        judgeJoints(*comparison, verdict);
        judgeConsistency(*comparison, verdict);
    }
    judgeRanges(data, verdict);
    judgeBoards(data, verdict);
    verdict.reasons.insert(verdict.reasons.end(), data.warnings.begin(), data.warnings.end());
    if (!comparison) {
        verdict.grade = Grade::kUnknown;
        verdict.headline = run ? "Not judged. Without a reference the error of this take is not known."
                               : "Not processed yet. The take holds no run to judge.";
        return verdict;
    }
    verdict.headline = gradeName(verdict.grade) + ". Mean joint error " +
                       text::degrees(comparison->mean_deg) + " against " + referenceName(data.take) + ".";
    return verdict;
}

const ReportRun* ReportData::shownRun() const {
    const auto shown = std::find_if(runs.begin(), runs.end(), [](const ReportRun& r) { return r.is_shown; });
    if (shown != runs.end())
        return &*shown;
    return runs.empty() ? nullptr : &runs.back();
}

}  // namespace noctule
