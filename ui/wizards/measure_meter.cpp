// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/measure_meter.h"

#include <QGridLayout>
#include <initializer_list>
#include <utility>

#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/bar_meter.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

constexpr int kGap = 6, kValueColumn = 2, kLineBar = 90;

}  // namespace

MeasureMeter::MeasureMeter(Form form)
    : icon_(new IconLabel("check", [] { return colorOf(Ink::kOk); })),
      name_(new Label({}, TextRole::kSecondary, Ink::kOk, true)),
      value_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      bar_(new BarMeter),
      grid_(makeGrid(this, {}, kGap)) {
    grid_->setColumnStretch(form == Form::kBelow ? kValueColumn - 1 : kValueColumn, 1);
    if (form == Form::kBelow)
        value_->wrapped();
    setForm(form);
}

void MeasureMeter::setForm(Form form) {
    bar_->setMinimumWidth(form == Form::kLine ? Theme::get().px(kLineBar) : 0);
    if (std::exchange(form_, form) == form)
        return;
    for (QWidget* part : std::initializer_list<QWidget*>{icon_, name_, value_, bar_})
        grid_->removeWidget(part);
    grid_->addWidget(icon_, 0, 0);
    grid_->addWidget(name_, 0, 1);
    switch (form) {
        case Form::kBeside:
            grid_->addWidget(value_, 0, kValueColumn, Qt::AlignRight);
            grid_->addWidget(bar_, 1, 0, 1, kValueColumn + 1);
            break;
        case Form::kBelow:
            grid_->addWidget(value_, 1, 0, 1, kValueColumn);
            grid_->addWidget(bar_, 2, 0, 1, kValueColumn);
            break;
        case Form::kLine:
            grid_->addWidget(value_, 0, kValueColumn, Qt::AlignRight);
            grid_->addWidget(bar_, 0, kValueColumn + 1, Qt::AlignVCenter);
            break;
    }
}

int MeasureMeter::widthBeside() const {
    const int gap = Theme::get().px(kGap);
    return icon_->sizeHint().width() + name_->sizeHint().width() + value_->sizeHint().width() + 2 * gap;
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
