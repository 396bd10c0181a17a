// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/big_button.h"

#include <QKeyEvent>
#include <QPainter>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/key_hint.h"

namespace noctule::ui {
namespace {

constexpr int kPadding = 16, kIcon = 20, kGap = 14, kRadius = 8;

}  // namespace

BigButton::BigButton(const QString& icon_name, const QString& title, const QString& about, bool primary,
                     QWidget* parent)
    : QAbstractButton(parent), icon_name_(icon_name), about_(about), primary_(primary) {
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(about);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void BigButton::setKeys(const QKeySequence& keys) {
    keys_ = keys;
    updateGeometry();
    update();
}

QFont BigButton::titleFont() const {
    return Theme::get().font(TextRole::kSection, true);
}

QFont BigButton::aboutFont() const {
    return Theme::get().font(TextRole::kSecondary);
}

QSize BigButton::sizeHint() const {
    const Theme& theme = Theme::get();
    const QFontMetrics title(titleFont()), about(aboutFont());
    const int words = std::max(title.horizontalAdvance(text()), about.horizontalAdvance(about_));
    const int key = keyWidth();
    return {theme.px(2 * kPadding + kIcon + kGap) + words + key,
            std::max(theme.px(64), title.height() + about.height() + theme.px(24))};
}

int BigButton::keyWidth() const {
    if (keys_.isEmpty())
        return 0;
    return KeyHint::sizeOf(keysText(keys_)).width() + Theme::get().px(kGap);
}

QSize BigButton::minimumSizeHint() const {
    return sizeHint();
}

QColor BigButton::background() const {
    const Tokens& tokens = Theme::get().tokens();
    const bool hovered = underMouse() && isEnabled();
    if (primary_)
        return isDown() ? tokens.acc.darker(112) : hovered ? tokens.acc.lighter(106) : tokens.acc;
    return isDown() ? tokens.ctl : hovered ? tokens.ctlh : tokens.raised;
}

void BigButton::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(background());
    const double radius = theme.px(kRadius);
    painter.drawRoundedRect(rect(), radius, radius);

    const QColor title_color = primary_ ? tokens.onacc : isEnabled() ? tokens.t1 : tokens.t3;
    const QColor about_color = primary_ ? tokens.onacc : tokens.t2;
    const int icon = theme.px(kIcon);
    painter.drawPixmap(theme.px(kPadding), (height() - icon) / 2,
                       theme.pixmap(icon_name_, icon, title_color));

    const QFontMetrics title(titleFont()), about(aboutFont());
    const int left = theme.px(kPadding + kIcon + kGap), gap = theme.px(4);
    const int top = (height() - title.height() - about.height() - gap) / 2;
    painter.setFont(titleFont());
    painter.setPen(title_color);
    painter.drawText(left, top + title.ascent(), text());
    painter.setFont(aboutFont());
    painter.setPen(about_color);
    const int room = width() - left - theme.px(kPadding) - keyWidth();
    painter.drawText(left, top + title.height() + gap + about.ascent(),
                     about.elidedText(about_, Qt::ElideRight, room));

    if (!keys_.isEmpty()) {
        const QString keys = keysText(keys_);
        const QSize size = KeyHint::sizeOf(keys);
        const QRectF frame(
            QPointF(width() - theme.px(kPadding) - size.width(), (height() - size.height()) / 2.0),
            QSizeF(size));
        KeyHint::paint(painter, frame, keys, about_color);
    }
}

void BigButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void BigButton::enterEvent(QEvent*) {
    update();
}

void BigButton::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
