// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/map_marker.h"

#include <QPainter>

#include "ui/style/theme.h"

namespace noctule::ui {

MapMarker::MapMarker(Shape shape, int number, const QString& name, QWidget* parent)
    : QAbstractButton(parent), shape_(shape) {
    setText(QString::number(number));
    setAccessibleName(name);
    setToolTip(name);
    setFocusPolicy(Qt::StrongFocus);
}

void MapMarker::setTone(Tone tone) {
    tone_ = tone;
    update();
}

void MapMarker::setChosen(bool chosen) {
    chosen_ = chosen;
    update();
}

QSize MapMarker::sizeHint() const {
    return {Theme::get().px(28), Theme::get().px(28)};
}

void MapMarker::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const bool board = shape_ == Shape::kBoard;
    const QColor color = tone_ == Tone::kNeutral ? (board ? tokens.t2 : tokens.acc) : colorOf(tone_);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool wide = board || text().size() > 1;
    const QSizeF size(theme.px(wide ? 20 : 16), theme.px(16));
    QRectF shape(QPointF(), size);
    shape.moveCenter(QRectF(rect()).center());
    const double radius = board ? theme.px(4) : size.height() / 2;
    painter.setBrush(chosen_ ? tokens.sel : underMouse() ? tokens.ctlh : tokens.view);
    // Nothing arrives: dashed, so that it is not told by colour alone.
    painter.setPen(QPen(color, chosen_ ? 2 : 1.5, tone_ == Tone::kError ? Qt::DashLine : Qt::SolidLine));
    painter.drawRoundedRect(shape, radius, radius);
    painter.setFont(theme.font(TextRole::kCaption, true));
    painter.setPen(color);
    painter.drawText(shape, Qt::AlignCenter, text());
}

void MapMarker::enterEvent(QEvent*) {
    update();
}

void MapMarker::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
