// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/status_dot.h"

#include <QPainter>

#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {

StatusDot::StatusDot(Tone tone, const QString& words, QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    describe(*this, {QAccessible::Graphic});
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(); });
    setState(tone, words);
}

void StatusDot::setState(Tone tone, const QString& words) {
    tone_ = tone;
    setToolTip(words);
    setAccessibleName(words);
    update();
}

QSize StatusDot::sizeHint() const {
    return {Theme::get().px(12), Theme::get().px(12)};
}

void StatusDot::paint(QPainter& painter, const QRect& area, Tone tone) {
    const Theme& theme = Theme::get();
    const double r = theme.px(8) / 2.0;
    const QPointF middle = QRectF(area).center();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colorOf(tone));
    if (tone == Tone::kWarn) {
        painter.drawPolygon(QVector<QPointF>{middle + QPointF(0, -r * 1.1),
                                             middle + QPointF(r * 1.15, r * 0.9),
                                             middle + QPointF(-r * 1.15, r * 0.9)});
    } else if (tone == Tone::kError) {
        painter.drawPolygon(QVector<QPointF>{middle + QPointF(0, -r * 1.2), middle + QPointF(r * 1.2, 0),
                                             middle + QPointF(0, r * 1.2), middle + QPointF(-r * 1.2, 0)});
    } else if (tone == Tone::kNeutral) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.tokens().edge, 1.5));
        painter.drawEllipse(middle, r - 0.75, r - 0.75);
    } else {
        painter.drawEllipse(middle, r, r);
    }
    painter.restore();
}

void StatusDot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, rect(), tone_);
}

}  // namespace noctule::ui
