// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/chip.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {

Chip::Chip(Tone tone, const QString& text, const QString& icon_name, QWidget* parent)
    : QAbstractButton(parent), tone_(tone) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(); });
    setState(tone, text, icon_name);
}

void Chip::setState(Tone tone, const QString& text, const QString& icon_name) {
    tone_ = tone;
    icon_name_ = icon_name.isEmpty() ? iconOf(tone) : icon_name;
    setText(text);
    updateGeometry();
    update();
}

void Chip::setInteractive(bool interactive) {
    interactive_ = interactive;
    setFocusPolicy(interactive ? Qt::TabFocus : Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents, !interactive);
}

void Chip::setBrief(bool brief) {
    if (brief == brief_)
        return;
    brief_ = brief;
    updateGeometry();
    update();
}

QSize Chip::sizeHint() const {
    const Theme& theme = Theme::get();
    const QFontMetrics metrics(theme.font(TextRole::kSecondary, true));
    const int words = brief_ ? 0 : theme.px(6) + metrics.horizontalAdvance(text());
    return {words + theme.px(10 + 14 + 10), std::max(theme.px(28), metrics.height() + theme.px(6))};
}

void Chip::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    // The target is 28 px high, the chip itself 24.
    const int inset = (height() - std::max(theme.px(24), fontMetrics().height() + theme.px(2))) / 2;
    const QRect box = rect().adjusted(0, inset, 0, -inset);
    QColor fill = backgroundOf(tone_);
    if (interactive_ && (underMouse() || isDown()))
        fill = mixed(fill, theme.tokens().t1, isDown() ? 0.16 : 0.08);
    paintBox(painter, box, box.height() / 2.0, fill);
    const QColor color = tone_ == Tone::kNeutral ? theme.tokens().t1 : colorOf(tone_);
    paintIcon(painter, QRect(theme.px(10), 0, theme.px(14), height()), icon_name_, theme.px(14), color);
    if (brief_)
        return;
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(color);
    painter.drawText(rect().adjusted(theme.px(30), 0, 0, 0), Qt::AlignVCenter, text());
}

void Chip::enterEvent(QEvent*) {
    update();
}

void Chip::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
