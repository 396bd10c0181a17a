// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/confidence_legend.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr double kWidth = 126, kHeight = 16, kBar = 8, kWords = 22;  // pixels at 100 percent

}  // namespace

ConfidenceLegend::ConfidenceLegend(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Colours of confidence from 0 to 1"));
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

QSize ConfidenceLegend::sizeHint() const {
    return {Theme::get().px(kWidth), Theme::get().px(kHeight)};
}

void ConfidenceLegend::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int words = theme.px(kWords), bar = theme.px(kBar);
    const QRectF area(words, (height() - bar) / 2.0, width() - 2 * words, bar);
    QLinearGradient gradient(area.topLeft(), area.topRight());
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i)
        gradient.setColorAt(double{1} * i / kStops, theme.confidence(double{1} * i / kStops));
    painter.setPen(Qt::NoPen);
    painter.setBrush(gradient);
    painter.drawRoundedRect(area, theme.px(2), theme.px(2));
    painter.setPen(theme.tokens().t2);
    painter.setFont(theme.font(TextRole::kCaption));
    painter.drawText(QRect(0, 0, words, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     numberText(0, kDecimals));
    painter.drawText(QRect(width() - words, 0, words, height()), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(1, kDecimals));
}

}  // namespace noctule::ui
