// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/body/text.h"
#include "core/report/html.h"
#include "core/report/pair_choice.h"
#include "core/report/range_statistics.h"
#include "core/report/sections.h"
#include "core/report/style.h"
#include "core/report/svg_plot.h"

namespace noctule {
namespace {

constexpr double kCellTop_px = 22, kCellHeight_px = 26, kGap_px = 2;

std::string at(const char* name, double value) {
    return std::string(" ") + name + "=\"" + text::coordinate(value) + "\"";
}

std::string words(const char* css_class, double x, double y, const std::string& content) {
    return std::string("<text class=\"") + css_class + "\"" + at("x", x) + at("y", y) + ">" +
           text::escaped(content) + "</text>";
}

std::string cellSentence(const ReportData& data, const ReportPair& pair, const RangeStatistics& s) {
    const auto residual_m = s.residualRms_m();
    return pairLabel(data, pair) + ": mean " + text::number(s.meanConfidence(), 2) + ", " +
           text::count(s.of(PulseFate::kUsed)) + " ranges used, " + text::count(s.of(PulseFate::kRejected)) +
           " rejected, " +
           (residual_m ? "residual " + text::number(1000 * *residual_m, 1) + " mm" : "no residual");
}

std::string cell(double x, double y, double width, const std::string& css_class,
                 const std::string& sentence) {
    return "<rect class=\"" + css_class + "\"" + at("x", x) + at("y", y) + at("width", width - kGap_px) +
           at("height", kCellHeight_px - kGap_px) + " rx=\"2\"><title>" + text::escaped(sentence) +
           "</title></rect>";
}

/// Sources down, boards across; a pair without pulses is a dashed empty cell, never the colour of zero.
std::string heatMap(const ReportData& data) {
    const double width = (kPlotRight_px - kPlotLeft_px) / static_cast<double>(data.boards.size());
    const double height = kCellTop_px + kCellHeight_px * static_cast<double>(data.sources.size());
    std::vector<std::string> cells(data.boards.size() * data.sources.size());
    const auto place = [&](int source, int board) -> std::string& {
        return cells[static_cast<size_t>(source) * data.boards.size() + static_cast<size_t>(board)];
    };
    const auto x_of = [&](int board) { return kPlotLeft_px + width * board; };
    const auto y_of = [&](int source) { return kCellTop_px + kCellHeight_px * source; };
    for (const ReportPair& pair : data.pairs) {
        const RangeStatistics s = rangeStatistics(pair);
        if (s.pulses() > 0)
            place(pair.source, pair.board) =
                cell(x_of(pair.board), y_of(pair.source), width, confidenceClass(s.meanConfidence()),
                     cellSentence(data, pair, s));
    }
    std::string out =
        "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 1000 " + text::coordinate(height + 22) +
        "\"><title>Mean confidence of every pair</title><desc>One row per source, one column per "
        "board; each cell names its figures</desc>";
    for (int b = 0; b < static_cast<int>(data.boards.size()); ++b)
        out += words("tick mid", x_of(b) + width / 2, 14, std::to_string(b + 1));
    for (int s = 0; s < static_cast<int>(data.sources.size()); ++s) {
        out += words("tick end", kPlotLeft_px - 8, y_of(s) + 17, "S" + std::to_string(s + 1));
        for (int b = 0; b < static_cast<int>(data.boards.size()); ++b)
            out += place(s, b).empty() ? cell(x_of(b), y_of(s), width, "none", "no pulses recorded")
                                       : place(s, b);
    }
    for (const BoardGroup& group : boardGroups(data)) {
        const double left = x_of(group.first), right = x_of(group.last + 1) - kGap_px;
        out += "<path class=\"group\" d=\"M" + text::coordinate(left) + " " + text::coordinate(height + 3) +
               "H" + text::coordinate(right) + "\"/>" +
               words("tick mid", (left + right) / 2, height + 17, group.name);
    }
    return out + "</svg>\n";
}

/// Mean over a second, centred: single pulses jump too much to show a course.
std::vector<double> runningMean(const std::vector<double>& time_s, const std::vector<double>& values) {
    std::vector<double> mean;
    double sum = 0;
    size_t begin = 0, end = 0;
    for (const double now_s : time_s) {
        while (end < time_s.size() && time_s[end] <= now_s + 0.5)
            sum += values[end++];
        while (time_s[begin] < now_s - 0.5)
            sum -= values[begin++];
        mean.push_back(sum / static_cast<double>(end - begin));
    }
    return mean;
}

std::string curve(const ReportData& data, const ReportPair& pair) {
    std::vector<double> time_s, confidence;
    for (const PulseAtBoard& pulse : pair.pulses) {
        time_s.push_back(pulse.time_s);
        confidence.push_back(std::isfinite(pulse.confidence) ? pulse.confidence : 0);
    }
    const std::vector<double> mean = runningMean(time_s, confidence);
    LinePlot plot;
    plot.title = pairLabel(data, pair);
    plot.description =
        "Confidence of each pulse over time as dots, 0 when not heard, and its mean over a second";
    plot.time_s = takeInterval(data);
    plot.values = {0, 1};
    plot.value_decimals = 1;
    plot.width_px = 488;
    plot.height_px = 84;
    plot.dots.push_back({time_s, confidence, "dot faint", ""});
    plot.curves.push_back({time_s, mean, "estimate", ""});
    return svg(plot);
}

}  // namespace

std::string confidenceSection(const ReportData& data) {
    if (data.pairs.empty() || data.boards.empty() || data.sources.empty())
        return html::section("confidence", "Confidence", "",
                             html::nothing("The take holds no pulses, so there is no confidence to show."));
    std::string body = html::heading("Mean over the take") + "<div class=\"scroll\">" + heatMap(data) +
                       "</div>" + html::scale("0", "1, good from 0.5") + html::heading("Over time") +
                       "<div class=\"pair\">";
    for (const ReportPair* pair : chosenPairs(data))
        body += curve(data, *pair);
    return html::section(
        "confidence", "Confidence",
        "How far each board could trust what it heard of each source: strength, continuity and "
        "angle, multiplied. Pulses that were not heard count as 0. Dots are single pulses, curves their mean "
        "over a second.",
        body + "</div>");
}

}  // namespace noctule
