// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/tone_card.h"

#include <QPainter>

#include "ui/style/theme.h"

namespace noctule::ui {

void ToneCard::setTone(Tone tone) {
    if (tone == tone_)
        return;
    tone_ = tone;
    update();
}

void ToneCard::paintEvent(QPaintEvent* event) {
    Card::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = Theme::get().px(2), inset = width / 2, radius = Theme::get().px(8);
    painter.setPen(QPen(tone_ == Tone::kNeutral ? Theme::get().tokens().edge : colorOf(tone_), width));
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), radius, radius);
}

}  // namespace noctule::ui
