// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/key_hint.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {

KeyHint::KeyHint(const QKeySequence& keys, QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(); });
    setKeys(keys);
}

void KeyHint::setKeys(const QKeySequence& keys) {
    text_ = keysText(keys);
    setAccessibleName(text_);
    updateGeometry();
    update();
}

QSize KeyHint::sizeOf(const QString& keys) {
    const Theme& theme = Theme::get();
    const QFontMetrics metrics(theme.font(TextRole::kCaption));
    const int height = std::max(theme.px(18), metrics.height() + theme.px(2));
    return {std::max(height, metrics.horizontalAdvance(keys) + theme.px(12)), height};
}

QSize KeyHint::sizeHint() const {
    return sizeOf(text_);
}

void KeyHint::paint(QPainter& painter, const QRectF& frame, const QString& keys, const QColor& color) {
    const Theme& theme = Theme::get();
    paintBox(painter, frame, theme.px(3), {}, color);
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(color);
    painter.drawText(frame, Qt::AlignCenter, keys);
}

void KeyHint::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, rect(), text_, Theme::get().tokens().t2);
}

}  // namespace noctule::ui
