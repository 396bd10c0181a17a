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

constexpr int kStripBins = 160;
constexpr double kManySources = 4;  // a position has three unknowns; one more checks it
constexpr double kStripTop_px = 4, kStripRow_px = 14;

const std::vector<std::pair<std::string, std::string>> kFateKey = {{"used", "used"},
                                                                   {"rejected", "rejected by the gate"},
                                                                   {"unused", "heard but unused"},
                                                                   {"occluded", "hidden by the body"},
                                                                   {"missing", "not heard, though in sight"}};

std::string fateBar(const RangeStatistics& s) {
    const double pulses = std::max(1.0, static_cast<double>(s.pulses()));
    std::vector<std::pair<double, std::string>> parts;
    std::string words;
    for (size_t i = 0; i < s.count.size(); ++i) {
        const double share = static_cast<double>(s.count[i]) / pulses;
        parts.emplace_back(share, kFateKey[i].first);
        words += (i ? ", " : "") + kFateKey[i].second + " " + text::percent(share);
    }
    return html::bar(parts, words);
}

html::Row countRow(const std::string& label, const RangeStatistics& s, const std::string& css_class) {
    const auto residual_m = s.residualRms_m();
    html::Row row{{text::escaped(label), text::count(s.pulses()), text::count(s.heard())}, css_class};
    for (const PulseFate fate : {PulseFate::kUsed, PulseFate::kRejected, PulseFate::kUnused,
                                 PulseFate::kOccluded, PulseFate::kMissing})
        row.cells_html.push_back(text::count(s.of(fate)));
    row.cells_html.push_back(residual_m ? text::number(1000 * *residual_m, 1) : "–");
    row.cells_html.push_back(fateBar(s));
    return row;
}

/// One row per board or per source, and all together.
std::string countTable(const ReportData& data, bool by_board) {
    html::Table table{by_board ? "Pulses by board" : "Pulses by source",
                      {{by_board ? "Board" : "Source", false},
                       {"Pulses"},
                       {"Heard"},
                       {"Used"},
                       {"Rejected"},
                       {"Unused"},
                       {"Hidden"},
                       {"Not heard"},
                       {"Residual mm"},
                       {"Shares", false}},
                      {}};
    const size_t rows = by_board ? data.boards.size() : data.sources.size();
    std::vector<RangeStatistics> statistics(rows);
    RangeStatistics all;
    for (const ReportPair& pair : data.pairs) {
        const RangeStatistics s = rangeStatistics(pair);
        statistics[static_cast<size_t>(by_board ? pair.board : pair.source)].merge(s);
        all.merge(s);
    }
    for (size_t i = 0; i < rows; ++i) {
        const int index = static_cast<int>(i);
        std::string label = by_board ? boardLabel(data, index) : sourceLabel(data, index);
        table.rows.push_back(countRow(text::capitalised(label), statistics[i], ""));
    }
    table.rows.push_back(countRow("All pairs", all, "total"));
    return html::table(table);
}

struct Bin {
    int pulses = 0, used = 0;
};

std::vector<Bin> binsOfBoard(const ReportData& data, int board) {
    std::vector<Bin> bins(kStripBins);
    const Interval time_s = takeInterval(data);
    for (const ReportPair& pair : data.pairs) {
        if (pair.board != board)
            continue;
        for (const PulseAtBoard& pulse : pair.pulses) {
            const double fraction = (pulse.time_s - time_s.min) / time_s.span();
            if (!(fraction >= 0 && fraction < 1))
                continue;
            Bin& bin = bins[static_cast<size_t>(fraction * kStripBins)];
            ++bin.pulses;
            bin.used += pulse.fate == PulseFate::kUsed;
        }
    }
    return bins;
}

/// Equal neighbours become one rectangle.
std::string stripRow(const std::vector<Bin>& bins, size_t sources, double y) {
    const double width = (kPlotRight_px - kPlotLeft_px) / kStripBins;
    const auto classOf = [sources](const Bin& bin) {
        if (bin.pulses == 0)
            return std::string();
        const double in_use = static_cast<double>(sources) * bin.used / bin.pulses;
        return confidenceClass(in_use / kManySources);
    };
    std::string out;
    for (size_t i = 0, end = 0; i < bins.size(); i = end) {
        const std::string css_class = classOf(bins[i]);
        for (end = i + 1; end < bins.size() && classOf(bins[end]) == css_class;)
            ++end;
        if (!css_class.empty())
            out += "<rect class=\"" + css_class + "\" x=\"" +
                   text::coordinate(kPlotLeft_px + width * static_cast<double>(i)) + "\" y=\"" +
                   text::coordinate(y) + "\" width=\"" +
                   text::coordinate(width * static_cast<double>(end - i) + 0.1) + "\" height=\"12\"/>";
    }
    return out;
}

/// Boards down, time across: how many sources on average gave the board a range in use.
std::string strip(const ReportData& data) {
    const double height = kStripTop_px + kStripRow_px * static_cast<double>(data.boards.size());
    std::string out = "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 1000 " + text::coordinate(height + 20) +
                      "\"><title>Sources in use by board over time</title><desc>One row per board; gaps "
                      "are pale</desc>";
    for (int b = 0; b < static_cast<int>(data.boards.size()); ++b) {
        const double y = kStripTop_px + kStripRow_px * b;
        out += "<text class=\"tick end\" x=\"48\" y=\"" + text::coordinate(y + 10) + "\">" +
               std::to_string(b + 1) + "</text>" + stripRow(binsOfBoard(data, b), data.sources.size(), y);
    }
    const Interval time_s = takeInterval(data);
    for (const double time : timeTicks(time_s))
        out += "<text class=\"tick mid\" x=\"" +
               text::coordinate(kPlotLeft_px + (kPlotRight_px - kPlotLeft_px) * time / time_s.span()) +
               "\" y=\"" + text::coordinate(height + 14) + "\">" + timeLabel(time, time_s) + "</text>";
    return out + "</svg>\n";
}

/// Distances of one pair: what was used, what was thrown out, and the gaps between.
std::string distancePlot(const ReportData& data, const ReportPair& pair) {
    std::array<std::vector<double>, 3> time_s, distance_m;  // used, rejected, unused
    for (const PulseAtBoard& pulse : pair.pulses) {
        const auto kind = static_cast<size_t>(pulse.fate);
        if (kind >= time_s.size())
            continue;
        time_s[kind].push_back(pulse.time_s);
        distance_m[kind].push_back(pulse.distance_m);
    }
    LinePlot plot;
    plot.title = pairLabel(data, pair);
    plot.description = "Measured distances over time by what became of them";
    plot.time_s = takeInterval(data);
    plot.values = niceInterval({distance_m[0], distance_m[1], distance_m[2]}, 0.1);
    plot.value_decimals = plot.values.span() < 0.5 ? 2 : 1;
    plot.unit = " m";
    plot.height_px = 96;
    plot.dots = {{time_s[2], distance_m[2], "dot unused", "heard but unused"},
                 {time_s[0], distance_m[0], "dot", "used"},
                 {time_s[1], distance_m[1], "dot rejected", "rejected"}};
    return svg(plot);
}

}  // namespace

std::string rangesSection(const ReportData& data) {
    if (data.pairs.empty() || data.boards.empty() || data.sources.empty())
        return html::section("ranges", "Ranges", "", html::nothing("The take holds no ranges."));
    std::string body = html::key(kFateKey) + countTable(data, true) + html::heading("By source") +
                       countTable(data, false) + html::heading("Sources in use, by board over time") +
                       "<div class=\"scroll\">" + strip(data) + "</div>" +
                       html::scale("no source", "four and more") +
                       html::heading("Distances of single pairs") + "<div class=\"scroll\">";
    for (const ReportPair* pair : chosenPairs(data))
        body += distancePlot(data, *pair);
    return html::section(
        "ranges", "Ranges",
        "What became of every pulse at every board: heard or not, used by the filter or thrown "
        "out because it did not fit the pose.",
        body + "</div>");
}

}  // namespace noctule
