// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/pulse_bars.h"

#include <QPainter>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr int kBarsHeight = 56, kNumbersHeight = 18;

}  // namespace

PulseBars::PulseBars(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Pulses heard"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void PulseBars::setConfidences(const std::vector<double>& confidences) {
    if (confidences == confidences_)
        return;
    confidences_ = confidences;
    QStringList words;
    for (size_t source = 0; source < confidences_.size(); ++source)
        words << (confidences_[source] < 0 ? tr("source %1: not heard").arg(source + 1)
                                           : tr("source %1: %2", "number, confidence")
                                                 .arg(source + 1)
                                                 .arg(numberText(confidences_[source], 2)));
    setAccessibleDescription(words.join(QStringLiteral(", ")));
    setToolTip(words.join('\n'));
    update();
}

QSize PulseBars::sizeHint() const {
    return {Theme::get().px(200), Theme::get().px(kBarsHeight)};
}

QSize PulseBars::minimumSizeHint() const {
    return {Theme::get().px(14) * static_cast<int>(std::max<size_t>(1, confidences_.size())),
            Theme::get().px(kBarsHeight)};
}

void PulseBars::paintEvent(QPaintEvent*) {
    if (confidences_.empty())
        return;
    const Theme& theme = Theme::get();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme.font(TextRole::kCaption));
    const double step = static_cast<double>(width()) / static_cast<double>(confidences_.size());
    const double room = height() - theme.px(kNumbersHeight), base = room;
    for (size_t source = 0; source < confidences_.size(); ++source) {
        const double left = step * static_cast<double>(source);
        const double confidence = confidences_[source];
        const QRectF slot(left + step * 0.2, 0, step * 0.6, room);
        if (confidence >= 0) {
            const double bar = std::max<double>(theme.px(2), confidence * room);
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme.confidence(confidence));
            painter.drawRoundedRect(QRectF(slot.left(), base - bar, slot.width(), bar), theme.px(2),
                                    theme.px(2));
        }
        painter.setPen(QPen(theme.tokens().edge, 1));
        painter.drawLine(QPointF(slot.left(), base), QPointF(slot.right(), base));
        painter.setPen(theme.tokens().t2);
        painter.drawText(QRectF(left, room, step, theme.px(kNumbersHeight)), Qt::AlignCenter,
                         QString::number(source + 1));
    }
}

}  // namespace noctule::ui
