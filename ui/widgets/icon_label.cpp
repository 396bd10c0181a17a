// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/icon_label.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {

IconLabel::IconLabel(const QString& icon_name, std::function<QColor()> color, int size, QWidget* parent)
    : QWidget(parent), icon_name_(icon_name), color_(std::move(color)), size_(size) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(); });
}

void IconLabel::setIcon(const QString& icon_name, std::function<QColor()> color) {
    icon_name_ = icon_name;
    color_ = std::move(color);
    update();
}

void IconLabel::setIconSize(int size_at_100_percent) {
    size_ = size_at_100_percent;
    updateGeometry();
}

QSize IconLabel::sizeHint() const {
    const int side = Theme::get().px(size_);
    return {side, side};
}

void IconLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintIcon(painter, rect(), icon_name_, Theme::get().px(size_), color_());
}

}  // namespace noctule::ui
