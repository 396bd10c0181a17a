// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/status_button.h"

#include <QPainter>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/key_hint.h"

namespace noctule::ui {
namespace {

constexpr int kPadding = 4, kGap = 6, kIcon = 14, kHeight = 24;

}  // namespace

StatusButton::StatusButton(const QString& text, QWidget* parent) : QAbstractButton(parent) {
    setText(text);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void StatusButton::setKeys(const QKeySequence& keys) {
    keys_ = keysText(keys);
    updateGeometry();
    update();
}

void StatusButton::setTone(Tone tone) {
    tone_ = tone;
    updateGeometry();
    update();
}

/// Width of key or icon with the gap after it.
int StatusButton::leading() const {
    const Theme& theme = Theme::get();
    if (!keys_.isEmpty())
        return KeyHint::sizeOf(keys_).width() + theme.px(kGap);
    return tone_ == Tone::kNeutral ? 0 : theme.px(kIcon + kGap);
}

QSize StatusButton::sizeHint() const {
    const Theme& theme = Theme::get();
    const QFontMetrics metrics(theme.font(TextRole::kSecondary));
    return {theme.px(2 * kPadding) + leading() + metrics.horizontalAdvance(text()),
            std::max(theme.px(kHeight), metrics.height())};
}

void StatusButton::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const QColor color = tone_ != Tone::kNeutral ? colorOf(tone_) : underMouse() ? tokens.t1 : tokens.t2;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int left = theme.px(kPadding), icon = theme.px(kIcon);
    if (!keys_.isEmpty()) {
        QRectF frame(QPointF(left, 0), QSizeF(KeyHint::sizeOf(keys_)));
        frame.moveTop((height() - frame.height()) / 2);
        KeyHint::paint(painter, frame, keys_, color);
    } else if (tone_ != Tone::kNeutral) {
        painter.drawPixmap(left, (height() - icon) / 2, theme.pixmap(iconOf(tone_), icon, color));
    }
    painter.setFont(theme.font(TextRole::kSecondary));
    painter.setPen(color);
    painter.drawText(rect().adjusted(left + leading(), 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
}

void StatusButton::enterEvent(QEvent*) {
    update();
}

void StatusButton::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
