// SPDX-License-Identifier: Apache-2.0
// The few shapes that all controls are drawn from.
#pragma once

#include <QColor>
#include <QPainter>
#include <QRectF>

namespace noctule::ui {

/// Sharp 1 px border inside `rect`; an invalid colour leaves fill or border out.
void paintBox(QPainter& painter, const QRectF& rect, double radius, const QColor& fill,
              const QColor& border = {});

/// Icon of resources/icons in the middle of `rect`.
void paintIcon(QPainter& painter, const QRectF& rect, const QString& name, int size_px, const QColor& color);

/// `a` with the share `t` of `b`.
QColor mixed(const QColor& a, const QColor& b, double t);

}  // namespace noctule::ui
