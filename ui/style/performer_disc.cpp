// SPDX-License-Identifier: Apache-2.0
#include "ui/style/performer_disc.h"

#include "ui/style/theme.h"

namespace noctule::ui {

QString performerLetter(int index) {
    return index < 26 ? QString(QChar('A' + index)) : QString::number(index + 1);
}

QColor performerColor(int index) {
    const auto& colors = Theme::get().tokens().performers;
    return colors[static_cast<size_t>(index) % colors.size()];
}

void paintPerformerDisc(QPainter& painter, const QRectF& disc, int index) {
    const QColor color = performerColor(index);
    const QColor letter = color.lightnessF() > 0.5 ? QColor(0x0B, 0x14, 0x24) : QColor(Qt::white);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawEllipse(disc);
    QFont font = Theme::get().font(TextRole::kCaption, true);
    font.setPixelSize(std::max(1, static_cast<int>(disc.height() * 0.62)));
    painter.setFont(font);
    painter.setPen(letter);
    painter.drawText(disc, Qt::AlignCenter, performerLetter(index));
    painter.restore();
}

QPixmap performerPixmap(int index, int size_px, double pixel_ratio) {
    QPixmap pixmap(QSize(size_px, size_px) * pixel_ratio);
    pixmap.setDevicePixelRatio(pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paintPerformerDisc(painter, QRectF(0.5, 0.5, size_px - 1, size_px - 1), index);
    return pixmap;
}

}  // namespace noctule::ui
