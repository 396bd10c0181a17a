// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/key_card.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/key_hint.h"

namespace noctule::ui {
namespace {

constexpr int kInner = 10, kSymbol = 20, kHigh = 56;

}  // namespace

KeyCard::KeyCard(const QString& icon_name, const QString& title, const QString& about,
                 const QKeySequence& keys, QWidget* parent)
    : QAbstractButton(parent), icon_name_(icon_name), keys_(keys) {
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setLook(Tone::kNeutral, title, about);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void KeyCard::setLook(Tone tone, const QString& title, const QString& about) {
    if (tone == tone_ && title == text() && about == about_)
        return;
    tone_ = tone;
    about_ = about;
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(about);
    setToolTip(about);
    updateGeometry();
    update();
}

QSize KeyCard::sizeHint() const {
    const Theme& theme = Theme::get();
    const QFontMetrics title(theme.font(TextRole::kBody, true)), about(theme.font(TextRole::kCaption));
    const int key = KeyHint::sizeOf(keysText(keys_)).width();
    const int words = title.horizontalAdvance(text()) + theme.px(8) + key;
    return {words + theme.px(2 * kInner + kSymbol + 8),
            std::max(theme.px(kHigh), title.height() + about.height() + theme.px(16))};
}

void KeyCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    const bool is_plain = tone_ == Tone::kNeutral;
    const QColor edge = is_plain ? tokens.edge : colorOf(tone_);
    const QColor fill = isDown() || underMouse() ? tokens.ctlh
                        : is_plain               ? tokens.panel
                                                 : backgroundOf(tone_);
    paintBox(painter, rect().adjusted(0, 0, -1, -1), 4, isEnabled() ? fill : tokens.panel,
             isEnabled() ? edge : tokens.line);
    const QColor ink = !isEnabled() ? tokens.t3 : is_plain ? tokens.t1 : colorOf(tone_);
    const int inner = theme.px(kInner), symbol = theme.px(kSymbol);
    paintIcon(painter, QRect(inner, 0, symbol, height()), icon_name_, symbol, ink);
    const QFontMetrics title(theme.font(TextRole::kBody, true)), about(theme.font(TextRole::kCaption));
    const int left = inner + symbol + theme.px(8), right = width() - inner;
    const QString keys = keysText(keys_);
    const QSize key = KeyHint::sizeOf(keys);
    const bool has_about = !about_.isEmpty();
    const int top = (height() - title.height() - (has_about ? about.height() : 0)) / 2;
    painter.setFont(theme.font(TextRole::kBody, true));
    painter.setPen(ink);
    painter.drawText(QRect(left, top, right - key.width() - theme.px(8) - left, title.height()),
                     Qt::AlignVCenter, text());
    KeyHint::paint(
        painter,
        QRectF(right - key.width(), top + (title.height() - key.height()) / 2.0, key.width(), key.height()),
        keys, ink);
    if (!has_about)
        return;
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(isEnabled() ? tokens.t2 : tokens.t3);
    painter.drawText(QRect(left, top + title.height(), right - left, about.height()), Qt::AlignVCenter,
                     about.elidedText(about_, Qt::ElideRight, right - left));
}

void KeyCard::enterEvent(QEvent*) {
    update();
}

void KeyCard::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
