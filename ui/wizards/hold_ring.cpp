// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/hold_ring.h"

#include <QPainter>
#include <cmath>

#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {

HoldRing::HoldRing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void HoldRing::show(double share, double hold_s, Tone tone) {
    if (share == share_ && hold_s == hold_s_ && tone == tone_)
        return;
    share_ = share;
    hold_s_ = hold_s;
    tone_ = tone;
    setAccessibleName(tr("%1 of %2 seconds").arg(std::lround(share * hold_s)).arg(std::lround(hold_s)));
    update();
}

void HoldRing::showShare(double share, Tone tone) {
    if (share == share_ && hold_s_ == 0 && tone == tone_)
        return;
    share_ = share;
    hold_s_ = 0;
    tone_ = tone;
    setAccessibleName(percentText(share));
    update();
}

QSize HoldRing::sizeHint() const {
    return QSize(Theme::get().px(68), Theme::get().px(68));
}

void HoldRing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = Theme::get().px(6);
    const QRectF ring = QRectF(rect()).adjusted(width, width, -width, -width);
    painter.setPen(QPen(Theme::get().tokens().ctl, width));
    painter.drawEllipse(ring);
    if (share_ > 0) {
        painter.setPen(QPen(colorOf(tone_), width, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(ring, 90 * 16, -static_cast<int>(std::lround(share_ * 360 * 16)));
    }
    painter.setPen(Theme::get().tokens().t1);
    painter.setFont(Theme::get().font(TextRole::kSection));
    painter.drawText(rect(), Qt::AlignCenter,
                     hold_s_ == 0
                         ? percentText(share_)
                         : tr("%1 / %2 s").arg(std::floor(share_ * hold_s_)).arg(std::lround(hold_s_)));
}

}  // namespace noctule::ui
