// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/curve_lines.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {
namespace {

/// With fewer samples than this in a column all are drawn: there are no more of them than of column ends.
constexpr double kSparse = 2;
/// Painters of Qt lose their way beyond 16 bits.
constexpr double kFarAway_px = 20000;

/// The device's columns that cover a part of the canvas.
struct Columns {
    double from_s, to_s;
    int count;
    double first_centre_px, step_px;
    double centre(int column) const { return first_centre_px + column * step_px; }
};

Columns columnsOf(const CurveFrame& frame, double left_px, double right_px) {
    const double origin = frame.time.p1();
    const double first = std::floor((left_px - origin) * frame.ratio) - 1;
    const double last = std::ceil((right_px - origin) * frame.ratio) + 1;
    const auto timeOf = [&](double column) { return frame.time.invTransform(origin + column / frame.ratio); };
    return {timeOf(first), timeOf(last), static_cast<int>(last - first), origin + (first + 0.5) / frame.ratio,
            1 / frame.ratio};
}

struct Samples {
    size_t begin, end;
};

/// Those within the columns, and one beyond on both sides.
Samples samplesOf(const SeriesPyramid& curve, const Columns& columns) {
    const size_t before = curve.indexAt(columns.from_s), last = curve.indexAt(columns.to_s);
    if (last == curve.size())
        return {0, 0};
    return {before == curve.size() ? 0 : before, std::min(last + 2, curve.size())};
}

bool isSparse(const Samples& samples, const Columns& columns) {
    return static_cast<double>(samples.end - samples.begin) < kSparse * columns.count;
}

double yOf(const CurveFrame& frame, float value) {
    return std::clamp(frame.value.transform(double{value}), -kFarAway_px, kFarAway_px);
}

double xOf(const CurveFrame& frame, double t_s) {
    return std::clamp(frame.time.transform(t_s), -kFarAway_px, kFarAway_px);
}

/// A lone value still shows as one pixel.
void finish(std::vector<QPolygonF>& lines, QPolygonF& line, double pixel) {
    if (line.size() == 1) {
        const QPointF point = line.front();
        line = QPolygonF(QVector<QPointF>{point - QPointF(pixel / 2, 0), point + QPointF(pixel / 2, 0)});
    }
    if (!line.empty())
        lines.push_back(std::move(line));
    line = {};
}

std::vector<QPolygonF> sampleLines(const SeriesPyramid& curve, const CurveFrame& frame, Samples samples) {
    std::vector<QPolygonF> lines;
    QPolygonF line;
    const Series& series = curve.series();
    for (size_t i = samples.begin; i < samples.end; ++i) {
        if (std::isnan(series.value[i])) {
            finish(lines, line, 1 / frame.ratio);
            continue;
        }
        line.append({xOf(frame, series.t_s[i]), yOf(frame, series.value[i])});
    }
    finish(lines, line, 1 / frame.ratio);
    return lines;
}

void appendColumn(QPolygonF& line, double x, const SeriesColumn& column, const CurveFrame& frame) {
    line.append({x, yOf(frame, column.first)});
    if (column.min == column.max)
        return;
    line.append({x, yOf(frame, column.min)});
    line.append({x, yOf(frame, column.max)});
    line.append({x, yOf(frame, column.last)});
}

std::vector<QPolygonF> columnLines(const SeriesPyramid& curve, const CurveFrame& frame,
                                   const Columns& columns) {
    std::vector<QPolygonF> lines;
    QPolygonF line;
    const auto reduced = curve.columns(columns.from_s, columns.to_s, columns.count);
    for (int c = 0; c < columns.count; ++c) {
        const SeriesColumn& column = reduced[static_cast<size_t>(c)];
        if (column.breaks)
            finish(lines, line, columns.step_px);
        if (!column.empty)
            appendColumn(line, columns.centre(c), column, frame);
    }
    finish(lines, line, columns.step_px);
    return lines;
}

/// Collects both edges of a band and closes them to a polygon.
class BandEdges {
public:
    void append(double x, double y_low, double y_high) {
        low_.append({x, y_low});
        high_.append({x, y_high});
    }
    void finish(std::vector<QPolygonF>& polygons) {
        if (low_.size() > 1) {
            std::reverse(low_.begin(), low_.end());
            polygons.push_back(high_ + low_);
        }
        low_.clear();
        high_.clear();
    }

private:
    QPolygonF low_, high_;
};

}  // namespace

std::vector<QPolygonF> curveLines(const SeriesPyramid& curve, const CurveFrame& frame, double left_px,
                                  double right_px) {
    const Columns columns = columnsOf(frame, left_px, right_px);
    const Samples samples = samplesOf(curve, columns);
    return isSparse(samples, columns) ? sampleLines(curve, frame, samples)
                                      : columnLines(curve, frame, columns);
}

std::vector<QPolygonF> bandPolygons(const SeriesPyramid& low, const SeriesPyramid& high,
                                    const CurveFrame& frame, double left_px, double right_px) {
    std::vector<QPolygonF> polygons;
    BandEdges edges;
    const Columns columns = columnsOf(frame, left_px, right_px);
    const Samples samples = samplesOf(low, columns);
    if (isSparse(samples, columns)) {
        for (size_t i = samples.begin; i < samples.end; ++i) {
            const float below = low.series().value[i], above = high.series().value[i];
            if (std::isnan(below) || std::isnan(above))
                edges.finish(polygons);
            else
                edges.append(xOf(frame, low.series().t_s[i]), yOf(frame, below), yOf(frame, above));
        }
        edges.finish(polygons);
        return polygons;
    }
    const auto below = low.columns(columns.from_s, columns.to_s, columns.count);
    const auto above = high.columns(columns.from_s, columns.to_s, columns.count);
    for (int c = 0; c < columns.count; ++c) {
        const auto i = static_cast<size_t>(c);
        if (below[i].breaks || above[i].breaks)
            edges.finish(polygons);
        if (!below[i].empty && !above[i].empty)
            edges.append(columns.centre(c), yOf(frame, below[i].min), yOf(frame, above[i].max));
    }
    edges.finish(polygons);
    return polygons;
}

}  // namespace noctule::ui
