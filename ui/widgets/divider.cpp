// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/divider.h"

#include <QPainter>

#include "ui/style/theme.h"

namespace noctule::ui {

Divider::Divider(Qt::Orientation orientation, QWidget* parent) : QWidget(parent) {
    const bool horizontal = orientation == Qt::Horizontal;
    setSizePolicy(horizontal ? QSizePolicy::Expanding : QSizePolicy::Fixed,
                  horizontal ? QSizePolicy::Fixed : QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Divider::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(rect(), Theme::get().tokens().line);
}

}  // namespace noctule::ui
