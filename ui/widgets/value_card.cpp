// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/value_card.h"

#include <QBoxLayout>

#include "ui/widgets/accessible.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

ValueCard::ValueCard(const QString& value, const QString& caption, QWidget* parent) : Card(parent) {
    describe(*this, {QAccessible::StaticText});
    value_ = new Label({}, TextRole::kPage, Ink::kValue, true);
    caption_ = (new Label({}, TextRole::kCaption, Ink::kHint))->wrapped();
    auto* column = new QVBoxLayout(this);
    column->addWidget(value_);
    column->addWidget(caption_);
    column->addStretch(1);
    const auto restyle = [column] {
        const Theme& theme = Theme::get();
        column->setContentsMargins(theme.px(12), theme.px(8), theme.px(8), theme.px(10));
        column->setSpacing(theme.px(2));
    };
    connect(&Theme::get(), &Theme::changed, this, restyle);
    restyle();
    setValue(value);
    setCaption(caption);
}

void ValueCard::setValue(const QString& value, Tone tone) {
    value_->setText(value);
    value_->setInk(tone == Tone::kWarn ? Ink::kWarn : tone == Tone::kError ? Ink::kError : Ink::kValue);
    tellName();
}

void ValueCard::setCaption(const QString& caption) {
    caption_->setText(caption);
    tellName();
}

void ValueCard::tellName() {
    setAccessibleName(tr("%1 %2", "value and what it is").arg(value_->text(), caption_->text().simplified()));
}

}  // namespace noctule::ui
