// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/body/text.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/report/html.h"
#include "core/report/range_statistics.h"
#include "core/report/sections.h"
#include "core/report/svg_plot.h"
#include "core/report/take_verdict.h"
#include "core/report/verdict.h"

namespace noctule {
namespace {

std::string card(const std::string& value, const std::string& meaning) {
    return "<div class=\"card\"><b>" + text::escaped(value) + "</b><span>" + text::escaped(meaning) +
           "</span></div>";
}

std::string backedShare(const ReportData& data) {
    if (data.support.empty())
        return "–";
    double sum = 0;
    for (const JointSupport& joint : data.support)
        sum += joint.ranges;
    return text::percent(sum / static_cast<double>(data.support.size()));
}

std::string cards(const ReportData& data, const ReportRun* run) {
    const Comparison* c = run && run->comparison ? &*run->comparison : nullptr;
    const auto residual_m = quantileOf(residualSizes_m(data.pairs), 0.5);
    const std::string millimetres =
        c && c->end_effector_mm ? text::number(*c->end_effector_mm, 1) + " mm" : "–";
    return "<div class=\"cards\">" +
           card(c ? text::degrees(c->mean_deg) : "–", "mean joint error against the reference") +
           card(millimetres, "hands, feet and head, mean position error in the frame of the pelvis") +
           card(backedShare(data), "of frames backed by ranges, mean over joints") +
           card(residual_m ? text::number(1000 * *residual_m, 1) + " mm" : "–",
                "range residual, median of the ranges used") +
           "</div>\n";
}

std::string allButLast(const std::vector<std::string>& names) {
    std::string words;
    for (size_t i = 0; i + 1 < names.size(); ++i)
        words += (words.empty() ? "" : ", ") + shortText(names[i], limits::kShownName);
    return words;
}

/// Of a take of several performers: whose poses come from one joint estimate. Else empty.
std::string peopleSentences(const ReportData& data) {
    const auto lastOf = [](const std::vector<std::string>& names) {
        return shortText(names.back(), limits::kShownName);
    };
    std::string words;
    if (data.together.size() > 1)
        words = allButLast(data.together) + " and " + lastOf(data.together) + " were estimated together.";
    if (!words.empty() && !data.alone.empty())
        words += ' ';
    if (data.alone.size() > 1)
        words += allButLast(data.alone) + " and " + lastOf(data.alone) + " were each estimated alone.";
    else if (!data.alone.empty())
        words += lastOf(data.alone) + " was estimated alone.";
    return words;
}

std::string explanation(const ReportData& data, const ReportRun* run) {
    if (!run)
        return "Process the take, then evaluate it again.";
    std::string words = "Result " + run->name + ": sensors " + sensorsInWords(run->sensors) + ", estimator " +
                        estimatorInWords(run->estimator) + ", smoothing " + run->smoother + ", root " +
                        (run->root_given ? "given by another system" : "free") + ". ";
    constexpr VerdictLimits kLimits;
    if (run->comparison)
        words += "Compared over " + text::clock(run->comparison->duration_s) + " in " +
                 text::plural(run->comparison->frames, "frame", "frames") + " after " +
                 text::number(data.take.rest_s, 0) + " s of rest. Good: mean under " +
                 text::degrees(kLimits.good_mean_deg, 0) + " and no joint over " +
                 text::degrees(kLimits.good_joint_deg, 0) + "; usable: mean under " +
                 text::degrees(kLimits.usable_mean_deg, 0) + ".";
    else
        words += "Judged by what the angles rest on. Good: ranges back the joints " +
                 text::percent(kLimits.good_backed) + " of the time and fit the pose within " +
                 text::number(1000 * kLimits.good_residual_m, 0) +
                 " mm; usable: " + text::percent(kLimits.usable_backed) + " and " +
                 text::number(1000 * kLimits.usable_residual_m, 0) + " mm.";
    return words;
}

}  // namespace

std::string sourceLabel(const ReportData& data, int source) {
    const ReportSource& s = data.sources[static_cast<size_t>(source)];
    const std::string label = shortText(s.label, limits::kShownName);
    return "source " + std::to_string(source + 1) + (label.empty() ? "" : " (" + label + ")");
}

std::string boardLabel(const ReportData& data, int board) {
    const ReportBoard& b = data.boards[static_cast<size_t>(board)];
    return (b.segment.empty() ? shortText(b.id, limits::kShownName) : text::segmentLabel(b.segment)) +
           " (board " + std::to_string(board + 1) + ")";
}

std::string pairLabel(const ReportData& data, const ReportPair& pair) {
    return text::capitalised(sourceLabel(data, pair.source) + ", heard by " + boardLabel(data, pair.board));
}

Interval takeInterval(const ReportData& data) {
    return {data.take.begin_s, data.take.begin_s + std::max(data.take.duration_s, 1e-3)};
}

std::string summarySection(const ReportData& data) {
    const Verdict verdict = judge(data);
    const ReportRun* run = data.shownRun();
    const std::string people = peopleSentences(data);
    std::string out = "<section id=\"summary\" aria-labelledby=\"verdict\">" +
                      html::verdict(verdict.grade, verdict.headline, explanation(data, run)) +
                      (people.empty() ? "" : html::note(people)) + cards(data, run) +
                      html::problems(verdict.reasons);
    return out + "</section>\n";
}

}  // namespace noctule
