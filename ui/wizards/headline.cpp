// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/headline.h"

#include <QPainter>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

constexpr int kLargest_px = 76;

int largestHeadline() {
    return std::min(kLargest_px, Theme::get().px(kLargest_px));
}

}  // namespace

Headline::Headline(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::StaticText});
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void Headline::setText(const QString& text) {
    if (text == text_)
        return;
    text_ = text;
    setAccessibleName(text);
    update();
}

QSize Headline::sizeHint() const {
    return {Theme::get().px(600), largestHeadline() * 5 / 4};
}

QSize Headline::minimumSizeHint() const {
    return {Theme::get().px(200), largestHeadline() * 5 / 4};
}

QFont Headline::fitting() const {
    QFont font = Theme::get().font(TextRole::kInstruction, true);
    font.setPixelSize(largestHeadline());
    if (const int needed = QFontMetrics(font).horizontalAdvance(text_); needed > width())
        font.setPixelSize(std::max(Theme::get().px(16), largestHeadline() * width() / needed - 1));
    return font;
}

void Headline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::TextAntialiasing);
    painter.setPen(Theme::get().tokens().t1);
    painter.setFont(fitting());
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, text_);
}

}  // namespace noctule::ui
