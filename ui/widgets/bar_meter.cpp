// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/bar_meter.h"

#include <QPainter>
#include <algorithm>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {

BarMeter::BarMeter(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe(*this, {QAccessible::ProgressBar,
                     [this] { return fraction_; },
                     0,
                     1,
                     0,
                     {},
                     [this] { return percentText(fraction_); }});
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(); });
}

void BarMeter::setValue(double fraction, Tone tone, const QString& words) {
    fraction_ = fraction > 0 ? std::min(fraction, 1.0) : 0;
    tone_ = tone;
    setAccessibleName(words);
    tellValueChanged(*this, fraction_);
    update();
}

QSize BarMeter::sizeHint() const {
    return {Theme::get().px(64), Theme::get().px(8)};
}

QSize BarMeter::minimumSizeHint() const {
    return {Theme::get().px(24), Theme::get().px(8)};
}

void BarMeter::paint(QPainter& painter, const QRect& area, double fraction, const QColor& color) {
    const Theme& theme = Theme::get();
    const int thick = theme.px(4);
    QRectF bar(area.left(), area.top() + (area.height() - thick) / 2, area.width(), thick);
    paintBox(painter, bar, thick / 2.0, theme.tokens().ctlh);
    bar.setWidth(bar.width() * std::clamp(fraction, 0.0, 1.0));
    if (bar.width() >= 1)
        paintBox(painter, bar, std::min<double>(thick, bar.width()) / 2.0, color);
}

void BarMeter::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, rect(), fraction_, colorOf(tone_));
}

}  // namespace noctule::ui
