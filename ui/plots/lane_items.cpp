// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/lane_items.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "ui/plots/curve_lines.h"
#include "ui/plots/time_window.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr double kAboveGrid = 20;  ///< Qwt's grid is at 10
constexpr double kBandOpacity = 0.2;
constexpr double kFate_px = 5, kMark_px = 3, kTriangle_px = 3.5, kTick_px = 6;  // at 100 percent

/// The canvas in up to three parts with their opacity: before in, between, after out.
std::vector<std::pair<QRectF, double>> partsOf(const QRectF& canvas, const QwtScaleMap& time,
                                               const LaneEmphasis& emphasis) {
    const double in = std::clamp(time.transform(emphasis.in_s), canvas.left(), canvas.right());
    const double out = std::clamp(time.transform(emphasis.out_s), in, canvas.right());
    std::vector<std::pair<QRectF, double>> parts;
    const auto add = [&](double left, double right, double opacity) {
        if (right > left)
            parts.emplace_back(QRectF(left, canvas.top(), right - left, canvas.height()), opacity);
    };
    add(canvas.left(), in, TimeWindow::kOutside);
    add(in, out, 1);
    add(out, canvas.right(), TimeWindow::kOutside);
    return parts;
}

}  // namespace

QColor penColor(LanePen pen) {
    const Tokens& tokens = Theme::get().tokens();
    switch (pen) {
        case LanePen::kFirst:
            return tokens.acc;
        case LanePen::kSecond:
        case LanePen::kX:
            return tokens.x;
        case LanePen::kThird:
        case LanePen::kY:
            return tokens.y;
        case LanePen::kFourth:
            return tokens.t2;
        case LanePen::kZ:
            return tokens.z;
        case LanePen::kReference:
            return tokens.ref;
    }
    return tokens.t1;
}

QPen penOf(LanePen pen) {
    QPen line(penColor(pen), 1);
    line.setCosmetic(true);
    line.setJoinStyle(Qt::BevelJoin);
    line.setCapStyle(Qt::FlatCap);
    if (pen == LanePen::kReference)
        line.setDashPattern({4, 3});
    return line;
}

double fateSize() {
    return Theme::get().px(kFate_px);
}

void drawFate(QPainter& painter, const QPointF& centre, RangeFate fate) {
    const Tokens& tokens = Theme::get().tokens();
    const double r = fateSize() / 2;
    const auto outline = [&](const QColor& color) {
        painter.setPen(QPen(color, 1));
        painter.setBrush(Qt::NoBrush);
    };
    switch (fate) {
        case RangeFate::kUsed:
            painter.setPen(Qt::NoPen);
            painter.setBrush(tokens.acc);
            painter.drawEllipse(centre, r * 0.8, r * 0.8);
            break;
        case RangeFate::kWeighted:
            outline(tokens.warn);
            painter.drawEllipse(centre, r, r);
            break;
        case RangeFate::kGated:
            outline(tokens.err);
            painter.drawLine(centre - QPointF(r, r), centre + QPointF(r, r));
            painter.drawLine(centre - QPointF(r, -r), centre + QPointF(r, -r));
            break;
        case RangeFate::kBehindSource:
            outline(tokens.t3);
            painter.drawPolygon(QPolygonF(
                QVector<QPointF>{centre + QPointF(0, -r), centre + QPointF(r, r), centre + QPointF(-r, r)}));
            break;
        case RangeFate::kNoConfidence:
            outline(tokens.t3);
            painter.drawLine(centre - QPointF(r, 0), centre + QPointF(r, 0));
            break;
        case RangeFate::kNotTried:
            outline(tokens.t2);
            painter.drawRect(QRectF(centre.x() - r * 0.7, centre.y() - r * 0.7, r * 1.4, r * 1.4));
            break;
    }
}

CurveItem::CurveItem(LaneCurve curve) : curve_(std::move(curve)) {
    setZ(kAboveGrid);
    setRenderHint(RenderAntialiased);
}

void CurveItem::draw(QPainter* painter, const QwtScaleMap& time, const QwtScaleMap& value,
                     const QRectF& canvas) const {
    for (const auto& [part, opacity] : partsOf(canvas, time, emphasis_)) {
        painter->save();
        painter->setClipRect(part, Qt::IntersectClip);
        painter->setOpacity(opacity);
        drawPart(*painter, time, value, part);
        painter->restore();
    }
}

void CurveItem::drawPart(QPainter& painter, const QwtScaleMap& time, const QwtScaleMap& value,
                         const QRectF& part) const {
    const CurveFrame frame{time, value, painter.device()->devicePixelRatioF()};
    if (curve_.low && curve_.high) {
        QColor fill = penColor(curve_.pen);
        fill.setAlphaF(kBandOpacity);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        for (const QPolygonF& polygon :
             bandPolygons(*curve_.low, *curve_.high, frame, part.left(), part.right()))
            painter.drawPolygon(polygon);
    }
    painter.setPen(penOf(curve_.pen));
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& line : curveLines(*curve_.value, frame, part.left(), part.right()))
        painter.drawPolyline(line);
}

PointsItem::PointsItem(LaneCurve curve) : curve_(std::move(curve)) {
    setZ(kAboveGrid);
    setRenderHint(RenderAntialiased);
}

void PointsItem::draw(QPainter* painter, const QwtScaleMap& time, const QwtScaleMap& value,
                      const QRectF& canvas) const {
    const Series& series = curve_.value->series();
    const double margin_s = fateSize() * (time.s2() - time.s1()) / std::max(1.0, canvas.width());
    const auto begin = std::lower_bound(series.t_s.begin(), series.t_s.end(), time.s1() - margin_s);
    const auto end = std::upper_bound(begin, series.t_s.end(), time.s2() + margin_s);
    const double edge = fateSize() / 2;
    // Symbols that would fall on each other are drawn once.
    std::set<std::tuple<int, int, RangeFate>> drawn;
    const auto last = static_cast<size_t>(end - series.t_s.begin());
    for (auto i = static_cast<size_t>(begin - series.t_s.begin()); i < last; ++i) {
        if (std::isnan(series.value[i]))
            continue;
        // What lies beyond the axis stands at its edge.
        const QPointF at(time.transform(series.t_s[i]),
                         std::clamp(value.transform(double{series.value[i]}), canvas.top() + edge,
                                    canvas.bottom() - edge));
        const RangeFate fate = (*curve_.fate)[i];
        if (!drawn.emplace(qRound(at.x()), qRound(at.y()), fate).second)
            continue;
        const bool inside = series.t_s[i] >= emphasis_.in_s && series.t_s[i] <= emphasis_.out_s;
        painter->setOpacity(inside ? 1 : TimeWindow::kOutside);
        drawFate(*painter, at, fate);
    }
    painter->setOpacity(1);
}

MarksItem::MarksItem(LaneMarks marks) : marks_(std::move(marks)) {
    setZ(kAboveGrid);
}

void MarksItem::draw(QPainter* painter, const QwtScaleMap& time, const QwtScaleMap&,
                     const QRectF& canvas) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    painter->setFont(theme.font(TextRole::kCaption));
    const double mark = theme.px(kMark_px), triangle = theme.px(kTriangle_px), tick = theme.px(kTick_px);
    const double room = painter->fontMetrics().horizontalAdvance(QStringLiteral("00"));
    double last_x = -1e9, last_text_x = -1e9;
    for (size_t i = 0; i < marks_.t_s.size(); ++i) {
        const double x = std::floor(time.transform(marks_.t_s[i]));
        if (x < canvas.left() || x > canvas.right() || x == last_x)
            continue;
        last_x = x;
        switch (marks_.kind) {
            case LaneMarks::Kind::kLost:
                painter->fillRect(QRectF(x, canvas.bottom() - mark, 1, mark), tokens.t3);
                break;
            case LaneMarks::Kind::kClipped:
                painter->fillRect(QRectF(x, canvas.top(), 1, mark), tokens.warn);
                break;
            case LaneMarks::Kind::kSent:
                painter->fillRect(QRectF(x, canvas.bottom() - tick, 1, tick), tokens.t2);
                if (i < marks_.text.size() && x - last_text_x > room) {
                    painter->setPen(tokens.t2);
                    painter->drawText(QPointF(x + 2, canvas.bottom() - 2), marks_.text[i]);
                    last_text_x = x;
                }
                break;
            case LaneMarks::Kind::kArrival: {
                QColor line = tokens.ok;
                line.setAlphaF(TimeWindow::kOutside);
                painter->fillRect(QRectF(x, canvas.top(), 1, canvas.height()), line);
                painter->setPen(Qt::NoPen);
                painter->setBrush(tokens.ok);
                painter->drawPolygon(QPolygonF(QVector<QPointF>{
                    QPointF(x + 0.5 - triangle, canvas.top()), QPointF(x + 0.5 + triangle, canvas.top()),
                    QPointF(x + 0.5, canvas.top() + 1.5 * triangle)}));
            }
        }
    }
}

}  // namespace noctule::ui
