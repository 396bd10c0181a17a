// SPDX-License-Identifier: Apache-2.0
#include "core/report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/body/text.h"

namespace noctule {
namespace {

constexpr double kHole_s = 0.25;
constexpr double kTitle_px = 26, kTimeLabels_px = 20, kMargin_px = 6;
constexpr double kMostDotsPerColumn = 2;

double map(double value, const Interval& from, const Interval& to) {
    const double fraction = from.span() > 0 ? (value - from.min) / from.span() : 0;
    return to.min + std::clamp(fraction, 0.0, 1.0) * to.span();
}

/// Holes that are narrower than a pixel column cannot be seen; courses of long takes are that coarse.
bool isHole(double from_s, double to_s, const Interval& time_s, const Interval& x_px) {
    return to_s - from_s > std::max(kHole_s, time_s.span() / x_px.span());
}

std::string point(double x, double y) {
    return text::coordinate(x) + " " + text::coordinate(y);
}

struct Column {
    int index = -1;
    double first = 0, last = 0, least = 0, most = 0;
    size_t at_least = 0, at_most = 0;
};

/// Collects samples into columns and writes each column's first, extremes and last once.
class PathWriter {
public:
    PathWriter(const Interval& x_px, const Interval& value, const Interval& y_px)
        : x_px_(x_px), value_(value), y_px_(y_px) {}

    void add(double x, double value, size_t order) {
        const int index = static_cast<int>(x - x_px_.min);
        if (index != column_.index) {
            flush();
            column_ = {index, value, value, value, value, order, order};
        }
        column_.last = value;
        if (value < column_.least)
            column_.least = value, column_.at_least = order;
        if (value > column_.most)
            column_.most = value, column_.at_most = order;
    }
    void lift() {
        flush();
        column_.index = -1;
        pen_down_ = false;
    }
    std::string path() {
        flush();
        return std::move(path_);
    }

private:
    void flush() {
        if (column_.index < 0)
            return;
        const bool rising = column_.at_least < column_.at_most;
        to(rising ? column_.least : column_.most);
        if (column_.least != column_.most)
            to(rising ? column_.most : column_.least);
        column_.index = -1;
    }
    void to(double value) {
        const double y = map(value, value_, {y_px_.max, y_px_.min});
        path_ += (pen_down_ ? " " : "M") + point(x_px_.min + column_.index + 0.5, y);
        pen_down_ = true;
    }

    Interval x_px_, value_, y_px_;
    Column column_;
    bool pen_down_ = false;
    std::string path_;
};

struct Area {
    Interval x, y;
};

std::string path(const std::string& css_class, const std::string& d) {
    return d.empty() ? "" : "<path class=\"" + css_class + "\" d=\"" + d + "\"/>";
}

std::string line(double x1, double y1, double x2, double y2, const char* css_class) {
    return std::string("<path class=\"") + css_class + "\" d=\"M" + point(x1, y1) + " " + point(x2, y2) +
           "\"/>";
}

std::string label(double x, double y, const char* css_class, const std::string& content) {
    return "<text x=\"" + text::coordinate(x) + "\" y=\"" + text::coordinate(y) + "\" class=\"" + css_class +
           "\">" + content + "</text>";
}

struct BandColumn {
    int index;
    Interval edge;
};

/// The upper edge forth and the lower edge back.
std::string bandPolygon(const std::vector<BandColumn>& columns, const LinePlot& plot, const Area& area) {
    const auto corner = [&](const BandColumn& column, double value) {
        return point(area.x.min + column.index + 0.5, map(value, plot.values, {area.y.max, area.y.min}));
    };
    std::string d;
    for (const BandColumn& column : columns)
        d += (d.empty() ? "M" : " ") + corner(column, column.edge.max);
    for (auto column = columns.rbegin(); column != columns.rend(); ++column)
        d += " " + corner(*column, column->edge.min);
    return d.empty() ? "" : d + "Z";
}

/// One polygon for every unbroken part of the curve.
std::string bandPath(const PlotBand& band, const LinePlot& plot, const Area& area) {
    std::string d;
    std::vector<BandColumn> part;
    double last_s = -INFINITY;
    for (size_t i = 0; i < band.middle.size(); ++i) {
        const double time_s = band.time_s[i];
        const Interval edge{band.middle[i] - band.half_width[i], band.middle[i] + band.half_width[i]};
        const bool is_known = std::isfinite(edge.min) && std::isfinite(edge.max);
        if (!is_known || isHole(last_s, time_s, plot.time_s, area.x))
            d += bandPolygon(std::exchange(part, {}), plot, area);
        if (!is_known)
            continue;
        last_s = time_s;
        const int index = static_cast<int>(map(time_s, plot.time_s, area.x) - area.x.min);
        if (part.empty() || part.back().index != index)
            part.push_back({index, edge});
        Interval& widened = part.back().edge;
        widened = {std::min(widened.min, edge.min), std::max(widened.max, edge.max)};
    }
    return d + bandPolygon(part, plot, area);
}

/// Short strokes with round ends; at most two per column and class, which looks the same.
std::string dotsPath(const PlotDots& dots, const LinePlot& plot, const Area& area) {
    std::string d;
    int column = -1;
    double in_column = 0;
    for (size_t i = 0; i < dots.values.size(); ++i) {
        if (!std::isfinite(dots.values[i]))
            continue;
        const double x = map(dots.time_s[i], plot.time_s, area.x);
        const bool same = static_cast<int>(x) == column;
        in_column = same ? in_column + 1 : 1;
        column = static_cast<int>(x);
        if (in_column <= kMostDotsPerColumn)
            d += "M" + point(x, map(dots.values[i], plot.values, {area.y.max, area.y.min})) + "h0";
    }
    return d;
}

std::string legend(const LinePlot& plot) {
    struct Entry {
        std::string css_class, name;
        bool dots;
    };
    std::vector<Entry> entries;
    for (const PlotCurve& curve : plot.curves)
        if (!curve.name.empty())
            entries.push_back({curve.css_class, curve.name, false});
    for (const PlotDots& dots : plot.dots)
        if (!dots.name.empty())
            entries.push_back({dots.css_class, dots.name, true});
    std::string out;
    double x = plot.width_px - kPlotMargin_px;
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
        x -= 6.6 * static_cast<double>(entry->name.size()) + 4;
        out += label(x, 15, "legend", text::escaped(entry->name));
        out += entry->dots ? "<path class=\"" + entry->css_class + "\" d=\"M" + point(x - 10, 11) + "h0\"/>"
                           : line(x - 22, 11, x - 6, 11, entry->css_class.c_str());
        x -= 38;
    }
    return out;
}

std::string grid(const LinePlot& plot, const Area& area) {
    std::string out;
    for (const double value : ticks(plot.values, plot.height_px < 90 ? 3 : 5)) {
        const double y = map(value, plot.values, {area.y.max, area.y.min});
        out += line(area.x.min, y, area.x.max, y, "grid");
        out += label(area.x.min - 8, y + 4, "tick end",
                     text::number(value, plot.value_decimals) + text::escaped(plot.unit));
    }
    for (const double time : timeTicks(plot.time_s)) {
        const double x = map(time, plot.time_s, area.x);
        out += line(x, area.y.min, x, area.y.max, "grid");
        if (plot.time_labels)
            out += label(x, area.y.max + 15, "tick mid", timeLabel(time, plot.time_s));
    }
    return out;
}

}  // namespace

std::string decimatedPath(std::span<const double> time_s, std::span<const double> values,
                          const Interval& time, const Interval& value, const Interval& x_px,
                          const Interval& y_px) {
    PathWriter writer(x_px, value, y_px);
    double last_s = -INFINITY;
    for (size_t i = 0; i < std::min(time_s.size(), values.size()); ++i) {
        if (!std::isfinite(values[i]) || !std::isfinite(time_s[i])) {
            writer.lift();
            continue;
        }
        if (isHole(last_s, time_s[i], time, x_px))
            writer.lift();
        last_s = time_s[i];
        writer.add(map(time_s[i], time, x_px), values[i], i);
    }
    return writer.path();
}

std::vector<double> ticks(const Interval& interval, int most) {
    if (!(interval.span() > 0) || !std::isfinite(interval.span()))
        return {};
    double step = std::pow(10, std::floor(std::log10(interval.span() / most)));
    for (const double factor : {2.0, 2.5, 2.0})  // 1, 2, 5, 10
        if (interval.span() / step > most)
            step *= factor;
    std::vector<double> values;
    for (double i = std::ceil(interval.min / step - 1e-9); i * step <= interval.max + 1e-9 * step; ++i)
        values.push_back(i * step);
    return values;
}

std::vector<double> timeTicks(const Interval& time_s) {
    for (const double step :
         {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0})
        if (time_s.span() / step <= 10) {
            std::vector<double> values;
            for (double i = std::ceil(time_s.min / step - 1e-9); i * step <= time_s.max; ++i)
                values.push_back(i * step);
            return values;
        }
    return ticks(time_s, 10);
}

std::string timeLabel(double time_s, const Interval& interval_s) {
    return interval_s.span() < 6 ? text::number(time_s, 1) + " s" : text::clock(time_s);
}

Interval niceInterval(const std::vector<std::span<const double>>& values, double least_span) {
    Interval all{INFINITY, -INFINITY};
    for (const auto& series : values)
        for (const double value : series)
            if (std::isfinite(value))
                all = {std::min(all.min, value), std::max(all.max, value)};
    if (all.min > all.max)
        return {0, least_span};
    const double widen = std::max(0.0, least_span - all.span()) / 2;
    all = {all.min - widen, all.max + widen};
    const std::vector<double> round = ticks(all, 5);
    const double step = round.size() > 1 ? round[1] - round[0] : all.span();
    return {std::floor(all.min / step + 1e-9) * step, std::ceil(all.max / step - 1e-9) * step};
}

std::string svg(const LinePlot& plot) {
    const Area area{{kPlotLeft_px, plot.width_px - kPlotMargin_px}, {kTitle_px, kTitle_px + plot.height_px}};
    const double height = area.y.max + (plot.time_labels ? kTimeLabels_px : kMargin_px);
    std::string out = "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 " + text::coordinate(plot.width_px) +
                      " " + text::coordinate(height) + "\"><title>" + text::escaped(plot.title) +
                      "</title><desc>" + text::escaped(plot.description) + "</desc>";
    out += label(0, 15, "head", text::escaped(plot.title)) + legend(plot) + grid(plot, area);
    for (const PlotBand& band : plot.bands)
        out += path("band", bandPath(band, plot, area));
    for (const PlotCurve& curve : plot.curves)
        out += path(curve.css_class,
                    decimatedPath(curve.time_s, curve.values, plot.time_s, plot.values, area.x, area.y));
    for (const PlotDots& dots : plot.dots)
        out += path(dots.css_class, dotsPath(dots, plot, area));
    return out + "</svg>\n";
}

}  // namespace noctule
