// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/card.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {

Card::Card(QWidget* parent) : QWidget(parent) {
    connect(&Theme::get(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Card::setSelected(bool selected) {
    selected_ = selected;
    update();
}

void Card::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    paintBox(painter, rect(), theme.px(8), selected_ ? theme.tokens().sel : theme.tokens().raised);
}

}  // namespace noctule::ui
