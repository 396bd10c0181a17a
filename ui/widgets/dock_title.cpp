// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/dock_title.h"

#include <QBoxLayout>
#include <QPainter>

#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"
#include "ui/widgets/elided_label.h"

namespace noctule::ui {

DockTitle::DockTitle(const QString& title, QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Heading});
    title_ = new ElidedLabel({}, TextRole::kBody, Ink::kValue, true);
    hint_ = new Label({}, TextRole::kSecondary, Ink::kLabel);
    hint_->setVisible(false);
    row_ = new QHBoxLayout(this);
    row_->addWidget(title_, 1);
    row_->addWidget(hint_);
    const auto restyle = [this] {
        const Theme& theme = Theme::get();
        row_->setContentsMargins(theme.px(12), 0, theme.px(8), 1);
        row_->setSpacing(theme.px(4));
        updateGeometry();
    };
    connect(&Theme::get(), &Theme::changed, this, restyle);
    restyle();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setTitle(title);
}

void DockTitle::setTitle(const QString& title) {
    title_->setText(title);
    setAccessibleName(title);
}

void DockTitle::setHint(const QString& hint) {
    hint_->setText(hint);
    hint_->setVisible(!hint.isEmpty());
}

void DockTitle::addAction(QWidget* widget) {
    row_->addWidget(widget);
}

QSize DockTitle::sizeHint() const {
    return {row_->sizeHint().width(), std::max(Theme::get().px(36), row_->sizeHint().height())};
}

QSize DockTitle::minimumSizeHint() const {
    return {row_->minimumSize().width(), sizeHint().height()};
}

void DockTitle::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(QRect(0, height() - 1, width(), 1), Theme::get().tokens().line);
}

}  // namespace noctule::ui
