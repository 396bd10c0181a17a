// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/rig_canvas.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/style/paint.h"

namespace noctule::ui {

RigCanvas::RigCanvas(QPainter& painter, const QSize& size)
    : painter_(painter), theme_(Theme::get()), size_(size) {
    painter_.setRenderHint(QPainter::Antialiasing);
}

void RigCanvas::fit(const RigCamera& camera, const std::vector<Vector3d>& points) {
    camera_ = camera;
    const double side = px(28), above = 2 * letterRadius_px() + px(6), below = px(12);
    camera_.fit(points, QRectF(side, above, size_.width() - 2 * side, size_.height() - above - below));
}

/// Words and strokes grow with the drawing, since it is looked at from further away.
double RigCanvas::px(double at_100_percent) const {
    const double grown = std::min(size_.width() / theme_.px(800), size_.height() / theme_.px(430));
    return at_100_percent * theme_.scale() * std::clamp(grown, 1.0, 1.6);
}

QFont RigCanvas::font(TextRole role, bool medium) const {
    QFont font = theme_.font(role, medium);
    font.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * px(1) / theme_.scale())));
    return font;
}

double RigCanvas::letterRadius_px() const {
    return std::clamp(std::min(size_.width() / 1.8, size_.height()) * 0.034, px(11), px(18));
}

/// Light falls from above, in front and a little from the right.
QColor RigCanvas::lit(const QColor& color, const Vector3d& normal) const {
    static const Vector3d kToLight = Vector3d(0.25, 0.75, 0.6).normalized();
    const double shadow = 0.5 * (1 - std::max(0.0, normal.dot(kToLight)));
    return mixed(color, theme_.isDark() ? tokens().bg : tokens().edge,
                 theme_.isDark() ? shadow : 0.6 * shadow);
}

void RigCanvas::use(const RigLook& look, const QColor& fill) {
    painter_.setBrush(fill.isValid() ? QBrush(fill) : QBrush(Qt::NoBrush));
    if (!look.outline.isValid()) {
        painter_.setPen(Qt::NoPen);
        return;
    }
    QPen pen(look.outline, px(look.width), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (look.dashed)
        pen.setDashPattern({4, 3});
    painter_.setPen(pen);
}

void RigCanvas::polygon(const std::vector<Vector3d>& corners, const RigLook& look, bool closed) {
    const QPolygonF line = seen(corners);
    use(look, look.fill);
    if (closed)
        painter_.drawPolygon(line);
    else
        painter_.drawPolyline(line);
}

void RigCanvas::box(const RigPlace& place, const Vector3d& low, const Vector3d& high, const RigLook& look) {
    const Vector3d ends[2] = {low, high};
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            Vector3d normal = Vector3d::Zero();
            normal[axis] = end == 1 ? 1 : -1;
            normal = place.turn * normal;
            if (camera_.nearness(normal) <= 1e-6)
                continue;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            QPolygonF face;
            for (const auto& [at_u, at_v] :
                 {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
                Vector3d corner;
                corner[axis] = ends[end][axis];
                corner[u] = ends[at_u][u];
                corner[v] = ends[at_v][v];
                face << at(place * corner);
            }
            use(look, look.fill.isValid() ? lit(look.fill, normal) : QColor());
            painter_.drawPolygon(face);
        }
}

QTransform RigCanvas::plane(const Vector3d& centre, const Vector3d& right, const Vector3d& up) const {
    const QPointF c = at(centre), x = camera_.along(right), y = camera_.along(up);
    return {x.x(), x.y(), -y.x(), -y.y(), c.x(), c.y()};
}

void RigCanvas::makeUpright(Vector3d& right, Vector3d& up) const {
    for (int quarter = 0; quarter < 3 && camera_.along(right).x() < std::abs(camera_.along(up).x());
         ++quarter) {
        const Vector3d before = right;
        right = up;
        up = -before;
    }
}

void RigCanvas::text(const QString& words, const Vector3d& centre, const Vector3d& right, const Vector3d& up,
                     const QColor& color) {
    Vector3d x = right, y = up;
    makeUpright(x, y);
    constexpr int kEm = 100;
    QFont em = font(TextRole::kBody, true);
    em.setPixelSize(kEm);
    QPainterPath path;
    path.addText(0, 0, em, words);
    const QRectF bounds = path.boundingRect();
    path.translate(-bounds.center().x(), QFontMetricsF(em).capHeight() / 2);
    keepReadable(at(centre), 0.9 * std::hypot(camera_.along(y).x(), camera_.along(y).y()));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(color);
    painter_.drawPath((QTransform::fromScale(1.0 / kEm, 1.0 / kEm) * plane(centre, x, y)).map(path));
}

void RigCanvas::check(const Vector3d& centre, const Vector3d& right, const Vector3d& up,
                      const QColor& color) {
    const QPointF c = at(centre);
    const double size = std::min(std::hypot(camera_.along(right).x(), camera_.along(right).y()),
                                 std::hypot(camera_.along(up).x(), camera_.along(up).y()));
    painter_.setPen(QPen(color, std::max(px(1.5), 0.28 * size), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(QVector<QPointF>{c + size * QPointF(-0.8, 0.05), c + size * QPointF(-0.2, 0.6),
                                           c + size * QPointF(0.9, -0.6)});
}

QPolygonF RigCanvas::seen(const std::vector<Vector3d>& corners) const {
    QPolygonF polygon;
    for (const Vector3d& corner : corners)
        polygon << at(corner);
    return polygon;
}

}  // namespace noctule::ui
