// SPDX-License-Identifier: Apache-2.0
#include "ui/style/paint.h"

#include <cmath>

#include "ui/style/icons.h"

namespace noctule::ui {

void paintBox(QPainter& painter, const QRectF& rect, double radius, const QColor& fill,
              const QColor& border) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(fill.isValid() ? QBrush(fill) : QBrush(Qt::NoBrush));
    painter.setPen(border.isValid() ? QPen(border, 1) : QPen(Qt::NoPen));
    const double inset = border.isValid() ? 0.5 : 0;
    painter.drawRoundedRect(rect.adjusted(inset, inset, -inset, -inset), radius, radius);
    painter.restore();
}

void paintIcon(QPainter& painter, const QRectF& rect, const QString& name, int size_px, const QColor& color) {
    const QPointF corner(std::round(rect.center().x() - size_px / 2.0),
                         std::round(rect.center().y() - size_px / 2.0));
    painter.drawPixmap(corner, drawIcon(name, size_px, color, painter.device()->devicePixelRatioF()));
}

QColor mixed(const QColor& a, const QColor& b, double t) {
    return QColor::fromRgbF(a.redF() + t * (b.redF() - a.redF()), a.greenF() + t * (b.greenF() - a.greenF()),
                            a.blueF() + t * (b.blueF() - a.blueF()));
}

}  // namespace noctule::ui
