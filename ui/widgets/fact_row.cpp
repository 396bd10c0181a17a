// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/fact_row.h"

#include <QGridLayout>

#include "ui/style/theme.h"
#include "ui/widgets/bar_meter.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

FactRow::FactRow(const QString& icon_name, const QString& name, QWidget* parent)
    : QWidget(parent),
      icon_name_(icon_name),
      name_text_(name),
      icon_(new IconLabel(icon_name, [this] { return colorOf(tone_); })),
      value_(new Label({}, TextRole::kBody, Ink::kValue, true)),
      hint_(new Label({}, TextRole::kCaption, Ink::kHint)),
      bar_(new BarMeter) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(icon_, 0, 0);
    grid->addWidget(new Label(name, TextRole::kBody, Ink::kLabel), 0, 1);
    grid->addWidget(value_, 0, 2, Qt::AlignRight);
    grid->addWidget(hint_->wrapped(), 1, 1, 1, 2);
    grid->addWidget(bar_, 2, 1, 1, 2);
    grid->setColumnStretch(1, 1);
    const auto space = [grid] {
        grid->setHorizontalSpacing(Theme::get().px(8));
        grid->setVerticalSpacing(Theme::get().px(2));
    };
    space();
    connect(&Theme::get(), &Theme::changed, this, space);
    setFact({});
}

void FactRow::setFact(const Fact& fact) {
    if (fact.tone != tone_) {
        tone_ = fact.tone;
        const bool alarms = tone_ == Tone::kWarn || tone_ == Tone::kError;
        icon_->setIcon(alarms ? iconOf(tone_) : icon_name_, [this] { return colorOf(tone_); });
    }
    if (value_->text() != fact.value)
        value_->setText(fact.value);
    if (hint_->text() != fact.hint)
        hint_->setText(fact.hint);
    hint_->setVisible(!fact.hint.isEmpty());
    bar_->setVisible(fact.share.has_value());
    if (fact.share && *fact.share != bar_->fraction())
        bar_->setValue(*fact.share, fact.tone == Tone::kNeutral ? Tone::kAccent : fact.tone,
                       name_text_ + QLatin1Char(' ') + fact.value);
    setAccessibleName(name_text_ + QStringLiteral(": ") + fact.value);
    setAccessibleDescription(fact.hint);
}

QString FactRow::value() const {
    return value_->text();
}

QString FactRow::hint() const {
    return hint_->text();
}

}  // namespace noctule::ui
