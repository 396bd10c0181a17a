// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/measure_meter.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/bar_meter.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

MeasureMeter::MeasureMeter(Value value)
    : icon_(new IconLabel("check", [] { return colorOf(Ink::kOk); })),
      name_(new Label({}, TextRole::kSecondary, Ink::kOk, true)),
      value_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      bar_(new BarMeter) {
    auto* column = makeColumn(this, {}, 6);
    auto* head = addRow(column, 6);
    head->addWidget(icon_);
    head->addWidget(name_);
    head->addStretch();
    if (value == Value::kBeside)
        head->addWidget(value_);
    else
        column->addWidget(value_->wrapped());
    column->addWidget(bar_);
}

void MeasureMeter::setMeasure(const LiveMeasure& measure) {
    const bool right = measure.is_right;
    icon_->setIcon(right ? "check" : "warn", [right] { return colorOf(right ? Ink::kOk : Ink::kWarn); });
    name_->setInk(right ? Ink::kOk : Ink::kWarn);
    name_->setText(measure.name);
    value_->setText(measure.value);
    bar_->setValue(measure.share, right ? Tone::kOk : Tone::kWarn,
                   QStringLiteral("%1 %2").arg(measure.name, measure.value));
}

}  // namespace noctule::ui
