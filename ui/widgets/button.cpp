// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/button.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/key_hint.h"

namespace noctule::ui {

struct Button::Look {
    QColor fill, edge, text;
    double radius;
};

Button::Button(ButtonKind kind, const QString& text, const QString& icon_name, const QKeySequence& shortcut,
               QWidget* parent)
    : QPushButton(text, parent),
      kind_(kind),
      icon_name_(icon_name),
      shortcut_(shortcut),
      tall_(kind == ButtonKind::kPrimary) {
    setAutoDefault(false);
    setCursor(Qt::ArrowCursor);
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, &Button::restyle);
    restyle();
}

void Button::setIconName(const QString& icon_name) {
    icon_name_ = icon_name;
    restyle();
}

void Button::setShortcutHint(const QKeySequence& shortcut) {
    shortcut_ = shortcut;
    restyle();
}

void Button::setTall(bool tall) {
    tall_ = tall;
    restyle();
}

void Button::setFlush(bool flush) {
    flush_ = flush;
    restyle();
}

void Button::setDisabledBecause(const QString& reason) {
    if (isEnabled())
        enabled_tooltip_ = toolTip();
    setEnabled(reason.isEmpty());
    setToolTip(reason.isEmpty() ? enabled_tooltip_ : reason);
    setAccessibleDescription(reason.isEmpty() ? hintText() : reason);
}

void Button::restyle() {
    if (isEnabled())
        setAccessibleDescription(hintText());
    updateGeometry();
    update();
}

QString Button::hintText() const {
    return keysText(shortcut_);
}

QFont Button::textFont() const {
    return Theme::get().font(tall_ && kind_ != ButtonKind::kText ? TextRole::kSection : TextRole::kBody,
                             true);
}

int Button::contentWidth() const {
    const Theme& theme = Theme::get();
    int width = QFontMetrics(textFont()).size(Qt::TextShowMnemonic, text()).width();
    if (!icon_name_.isEmpty())
        width += theme.px(16) + (text().isEmpty() ? 0 : theme.px(8));
    if (!shortcut_.isEmpty())
        width += theme.px(8) + KeyHint::sizeOf(hintText()).width();
    return width;
}

QSize Button::sizeHint() const {
    const Theme& theme = Theme::get();
    const int margin = flush_ ? 0 : kind_ == ButtonKind::kText ? theme.px(8) : theme.px(tall_ ? 16 : 12);
    const int height = std::max(theme.px(tall_ ? 38 : 30), QFontMetrics(textFont()).height() + theme.px(6));
    return {contentWidth() + 2 * margin, height};
}

Button::Look Button::look() const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const bool lit = isEnabled() && (underMouse() || isDown());
    const double radius = kind_ == ButtonKind::kRecord ? height() / 2.0 : theme.px(4);
    if (!isEnabled())
        return {kind_ == ButtonKind::kText ? QColor() : tokens.panel,
                kind_ == ButtonKind::kText ? QColor() : tokens.line, tokens.t3, radius};
    switch (kind_) {
        case ButtonKind::kPrimary:
            return {lit ? mixed(tokens.acc, tokens.t1, isDown() ? 0.25 : 0.15) : tokens.acc,
                    {},
                    tokens.onacc,
                    radius};
        case ButtonKind::kRecord:
            return {
                lit ? mixed(tokens.rec, Qt::black, isDown() ? 0.2 : 0.1) : tokens.rec, {}, Qt::white, radius};
        case ButtonKind::kText:
            return {lit ? tokens.ctl : QColor(), {}, tokens.acc, radius};
        case ButtonKind::kOutlined:
            break;
    }
    const bool filled = isChecked() || isDown();
    return {filled ? tokens.sel : lit ? tokens.ctl : QColor(), tokens.edge, tokens.t1, radius};
}

void Button::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Look now = look();
    paintBox(painter, rect(), now.radius, now.fill, now.edge);
    paintContent(painter, now);
}

void Button::paintContent(QPainter& painter, const Look& look) const {
    const Theme& theme = Theme::get();
    int x = (width() - contentWidth()) / 2;
    if (!icon_name_.isEmpty()) {
        paintIcon(painter, QRect(x, 0, theme.px(16), height()), icon_name_, theme.px(16), look.text);
        x += theme.px(24);
    }
    painter.setFont(textFont());
    painter.setPen(look.text);
    const int words = painter.fontMetrics().size(Qt::TextShowMnemonic, text()).width();
    painter.drawText(QRect(x, 0, words + 1, height()), Qt::AlignVCenter | Qt::TextHideMnemonic, text());
    x += words + theme.px(8);
    if (!shortcut_.isEmpty()) {
        const QSize key = KeyHint::sizeOf(hintText());
        KeyHint::paint(painter, QRect(QPoint(x, (height() - key.height()) / 2), key), hintText(), look.text);
    }
}

void Button::enterEvent(QEvent* event) {
    QPushButton::enterEvent(event);
    update();
}

void Button::leaveEvent(QEvent* event) {
    QPushButton::leaveEvent(event);
    update();
}

Button* makeButton(ButtonKind kind, const QString& text, const QString& icon, const QKeySequence& shortcut,
                   QWidget* parent) {
    return new Button(kind, text, icon, shortcut, parent);
}

}  // namespace noctule::ui
