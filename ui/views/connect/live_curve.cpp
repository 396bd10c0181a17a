// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/live_curve.h"

#include <QPainter>
#include <algorithm>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kCurveHeight = 44;

}  // namespace

LiveCurve::LiveCurve(const QString& name, double full_scale, QWidget* parent)
    : QWidget(parent), full_scale_(full_scale) {
    setAccessibleName(name);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void LiveCurve::add(double t_s, const std::array<std::optional<double>, 3>& values) {
    if (!points_.empty() && t_s <= points_.back().t_s) {
        if (t_s == points_.back().t_s)
            return;
        points_.clear();
    }
    points_.push_back({t_s, values});
    while (points_.front().t_s < t_s - kSpan_s)
        points_.pop_front();
    update();
}

void LiveCurve::clear() {
    points_.clear();
    update();
}

QSize LiveCurve::sizeHint() const {
    return {Theme::get().px(200), Theme::get().px(kCurveHeight)};
}

QSize LiveCurve::minimumSizeHint() const {
    return {Theme::get().px(120), Theme::get().px(kCurveHeight)};
}

void LiveCurve::paintEvent(QPaintEvent*) {
    const Tokens& tokens = Theme::get().tokens();
    QPainter painter(this);
    const double middle = height() / 2.0;
    painter.setPen(QPen(tokens.grid, 1));
    painter.drawLine(QPointF(0, middle), QPointF(width(), middle));
    if (points_.empty())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const double end_s = points_.back().t_s;
    const std::array colors{tokens.x, tokens.y, tokens.z};
    for (size_t axis = 0; axis < 3; ++axis) {
        painter.setPen(QPen(colors[axis], 1));
        QPolygonF line;
        for (const Point& point : points_) {
            const std::optional<double>& value = point.values[axis];
            if (!value) {
                painter.drawPolyline(line);
                line.clear();
                continue;
            }
            const double share = std::clamp(*value / full_scale_, -1.0, 1.0);
            line << QPointF(width() * (1 - (end_s - point.t_s) / kSpan_s), middle - share * (middle - 1));
        }
        painter.drawPolyline(line);
    }
}

}  // namespace noctule::ui
