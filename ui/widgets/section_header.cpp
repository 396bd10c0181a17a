// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/section_header.h"

#include <QBoxLayout>

#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

SectionHeader::SectionHeader(const QString& title, const QString& hint, QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Heading});
    title_ = new Label({}, TextRole::kCaption, Ink::kHint);
    hint_ = new Label({}, TextRole::kCaption, Ink::kHint);
    row_ = new QHBoxLayout(this);
    row_->setContentsMargins(0, 0, 0, 0);
    row_->addWidget(title_, 1);
    row_->addWidget(hint_);
    const auto restyle = [this] {
        setMinimumHeight(Theme::get().px(24));
        row_->setSpacing(Theme::get().px(8));
    };
    connect(&Theme::get(), &Theme::changed, this, restyle);
    restyle();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setTitle(title);
    setHint(hint);
}

void SectionHeader::setTitle(const QString& title) {
    title_->setText(title);
    setAccessibleName(title);
}

void SectionHeader::setHint(const QString& hint) {
    hint_->setText(hint);
    hint_->setVisible(!hint.isEmpty());
}

void SectionHeader::addTrailing(QWidget* widget) {
    row_->addWidget(widget);
}

}  // namespace noctule::ui
