// SPDX-License-Identifier: Apache-2.0
// How the timeline looks.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/plots/time_ruler.h"
#include "ui/plots/timeline.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr double kGrip = 5, kFlagWidth = 9, kFlagHeight = 7, kLeastName = 24;  // pixels at 100 percent

/// A flag that flies to the right of its time.
QPolygonF flagAt(double x, double y) {
    const Theme& theme = Theme::get();
    const double w = theme.px(kFlagWidth), h = theme.px(kFlagHeight);
    return QPolygonF(
        QVector<QPointF>{{x, y}, {x + w, y}, {x + w * 0.7, y + h / 2}, {x + w, y + h}, {x, y + h}});
}

}  // namespace

void Timeline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Rows r = rows();
    bars_.paint(painter, contactLanes());
    paintRuler(painter, r);
    if (!overview_)
        return;
    paintGaps(painter, r);
    paintMarkers(painter, r);
    paintOverview(painter, r);
    paintCursor(painter, r);
}

void Timeline::paintRuler(QPainter& painter, const Rows& rows) const {
    const Theme& theme = Theme::get();
    const QRect& ruler = rows.ruler;
    painter.fillRect(ruler, theme.tokens().ctl);
    if (!overview_)
        return;
    const TimeCursor& time = review_.time();
    const auto inside = [&](double x) { return std::clamp(qRound(x), ruler.left(), ruler.right() + 1); };
    const int in = inside(xOf(time.in())), out = inside(xOf(time.out()));
    painter.fillRect(QRect(in, ruler.top(), out - in, ruler.height()), theme.tokens().sel);
    const RulerScale scale = rulerScale(window_.from(), window_.to(), ruler.width(), theme.px(72));
    const auto tick = [&](double t_s, double height) {
        painter.fillRect(QRectF(qRound(xOf(t_s)), ruler.bottom() + 1 - height, 1, height),
                         theme.tokens().edge);
    };
    for (const double t_s : scale.t_s)
        tick(t_s, ruler.height() * 0.5);
    for (const double t_s : scale.between)
        tick(t_s, ruler.height() * 0.3);
    if (overview_->rest_s) {
        const int from = inside(xOf(overview_->rest_s->first)), to = inside(xOf(overview_->rest_s->second));
        painter.fillRect(QRect(from, ruler.bottom() - theme.px(2) + 1, to - from, theme.px(2)),
                         theme.tokens().t3);
    }
    paintRulerLabels(painter, rows.labels, window_);
    const int grip = theme.px(kGrip);
    for (const double t_s : {time.in(), time.out()})
        if (t_s >= window_.from() && t_s <= window_.to()) {
            const int x = std::clamp(qRound(xOf(t_s)) - grip / 2, ruler.left(), ruler.right() + 1 - grip);
            painter.fillRect(QRect(x, ruler.top(), grip, ruler.height()), theme.tokens().acc);
        }
}

void Timeline::paintGaps(QPainter& painter, const Rows& rows) const {
    const Theme& theme = Theme::get();
    for (const auto& [from_s, to_s] : overview_->gaps_s) {
        if (to_s < window_.from() || from_s > window_.to())
            continue;
        const double left = std::max<double>(xOf(from_s), rows.left);
        const double right = std::min<double>(std::max(xOf(to_s), left + 2), rows.right);
        const QRectF area(left, rows.ruler.top(), right - left, rows.ruler.height());
        painter.fillRect(area, theme.tokens().warnbg);
        painter.fillRect(area, QBrush(theme.tokens().warn, Qt::BDiagPattern));
    }
}

void Timeline::paintMarkers(QPainter& painter, const Rows& rows) const {
    const Theme& theme = Theme::get();
    painter.setRenderHint(QPainter::Antialiasing);
    for (size_t i = 0; i < overview_->markers.size(); ++i) {
        const ReviewMarker& marker = overview_->markers[i];
        if (marker.t_s < window_.from() || marker.t_s > window_.to())
            continue;
        const QColor color = marker.kind == "user" ? theme.tokens().acc : theme.tokens().warn;
        const int x = qRound(xOf(marker.t_s));
        painter.setPen(static_cast<int>(i) == chosen_marker_ ? QPen(theme.tokens().t1, 1) : QPen(Qt::NoPen));
        painter.setBrush(color);
        painter.drawPolygon(flagAt(x + 0.5, rows.ruler.top() + 0.5));
        QColor pole = color;
        pole.setAlphaF(0.7);
        QPen line(pole, 1);
        line.setDashPattern({2, 3});
        painter.setPen(line);
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.drawLine(x, 0, x, rows.ruler.top());
        paintMarkerName(painter, rows, i);
        painter.setRenderHint(QPainter::Antialiasing);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

/// Beside its flag, as far as the next flag or grip leaves room.
void Timeline::paintMarkerName(QPainter& painter, const Rows& rows, size_t marker) const {
    const Theme& theme = Theme::get();
    const ReviewMarker& named = overview_->markers[marker];
    const double left = xOf(named.t_s) + theme.px(kFlagWidth + 3);
    double right = rows.right;
    for (const ReviewMarker& other : overview_->markers)
        if (other.t_s > named.t_s)
            right = std::min(right, xOf(other.t_s));
    for (const double grip_s : {review_.time().in(), review_.time().out()})
        if (grip_s > named.t_s)
            right = std::min(right, xOf(grip_s) - theme.px(kGrip));
    const QFont font = theme.font(TextRole::kCaption);
    const QRectF area(left, rows.ruler.top(), right - left - theme.px(3), rows.ruler.height() * 0.5);
    if (named.label.empty() || area.width() < theme.px(kLeastName))
        return;
    painter.setFont(font);
    painter.setPen(static_cast<int>(marker) == chosen_marker_ ? theme.tokens().t1 : theme.tokens().t2);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                     QFontMetrics(font).elidedText(QString::fromStdString(named.label), Qt::ElideRight,
                                                   static_cast<int>(area.width())));
}

void Timeline::paintOverview(QPainter& painter, const Rows& rows) const {
    if (window_.showsAll())
        return;
    const Theme& theme = Theme::get();
    const QRect& bar = rows.overview;
    painter.fillRect(bar, theme.tokens().line);
    const double duration_s = std::max(review_.time().duration(), TimeWindow::kShortest_s);
    const double left = window_.from() / duration_s * bar.width();
    const double span = std::max<double>(theme.px(8), window_.span() / duration_s * bar.width());
    painter.fillRect(QRectF(bar.left() + std::min(left, bar.width() - span), bar.top(), span, bar.height()),
                     theme.tokens().edge);
}

QRect Timeline::labelRect(const Rows& rows) const {
    const Theme& theme = Theme::get();
    const QFontMetrics metrics(theme.font(TextRole::kCaption, true));
    const int label_width = metrics.horizontalAdvance(timeText(review_.time().time(), 2)) + theme.px(10);
    const int x = std::clamp(qRound(xOf(review_.time().time())) - label_width / 2, 0, width() - label_width);
    return {x, rows.labels.top() + theme.px(1), label_width, rows.labels.height() - theme.px(2)};
}

void Timeline::paintCursor(QPainter& painter, const Rows& rows) const {
    const double t_s = review_.time().time();
    if (t_s < window_.from() || t_s > window_.to())
        return;
    const Theme& theme = Theme::get();
    const QRect label = labelRect(rows);
    painter.fillRect(QRect(qRound(xOf(t_s)), 0, theme.px(1), label.top()), theme.tokens().t1);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.tokens().t1);
    painter.drawRoundedRect(label, theme.px(3), theme.px(3));
    painter.setFont(theme.font(TextRole::kCaption, true));
    painter.setPen(theme.tokens().panel);
    painter.drawText(label, Qt::AlignCenter, timeText(t_s, 2));
}

}  // namespace noctule::ui
