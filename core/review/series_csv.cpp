// SPDX-License-Identifier: Apache-2.0
#include "core/review/series_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/formats/number_text.h"
#include "core/job/csv_cell.h"

namespace noctule {
namespace {

void appendValue(std::string& text, float value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    text.append(buffer, end);
}

}  // namespace

std::string seriesCsv(const std::vector<NamedSeries>& curves, double from_s, double to_s) {
    std::string text = "time_s";
    std::vector<size_t> next;
    for (const NamedSeries& curve : curves) {
        text += "," + csvCell(curve.name);
        const auto& t_s = curve.series->series().t_s;
        next.push_back(static_cast<size_t>(std::lower_bound(t_s.begin(), t_s.end(), from_s) - t_s.begin()));
    }
    text += '\n';
    while (true) {
        double t_s = std::numeric_limits<double>::infinity();
        for (size_t c = 0; c < curves.size(); ++c)
            if (next[c] < curves[c].series->size())
                t_s = std::min(t_s, curves[c].series->series().t_s[next[c]]);
        if (!(t_s <= to_s))
            return text;
        appendFixed(text, t_s, 6);
        for (size_t c = 0; c < curves.size(); ++c) {
            const Series& series = curves[c].series->series();
            text += ',';
            if (next[c] >= series.t_s.size() || series.t_s[next[c]] > t_s)
                continue;
            if (std::isfinite(series.value[next[c]]))
                appendValue(text, series.value[next[c]]);
            ++next[c];
        }
        text += '\n';
    }
}

}  // namespace noctule
