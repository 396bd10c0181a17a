// SPDX-License-Identifier: Apache-2.0
#include "ui/views/number_rows.h"

#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/bar_meter.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

QColor iconColor(Tone tone) {
    return tone == Tone::kNeutral || tone == Tone::kOk ? Theme::get().tokens().t2 : colorOf(tone);
}

}  // namespace

NumberRows::NumberRows(QWidget* parent) : QWidget(parent), column_(makeColumn(this, {}, 10)) {}

int NumberRows::addRow(const QString& icon, const QString& name) {
    Row row{};
    row.widget = new QWidget;
    row.icon_name = icon;
    row.icon = new IconLabel(icon, [] { return iconColor(Tone::kNeutral); });
    row.name = new Label(name, TextRole::kBody, Ink::kLabel);
    row.value = new Label({}, TextRole::kBody, Ink::kValue, true);
    row.hint = (new Label({}, TextRole::kCaption, Ink::kHint))->wrapped();
    row.bar = new BarMeter;
    row.bar->setAccessibleName(name);
    auto* column = makeColumn(row.widget, {}, 2);
    auto* line = ui::addRow(column, 8);
    line->addWidget(row.icon);
    line->addWidget(row.name, 1);
    line->addWidget(row.value);
    ui::addRow(column, 0, {24, 0, 0, 0})->addWidget(row.hint);
    column->addWidget(row.bar);
    column_->addWidget(row.widget);
    row.bar->hide();
    row.hint->parentWidget()->hide();
    row.widget->hide();
    rows_.push_back(row);
    return static_cast<int>(rows_.size()) - 1;
}

void NumberRows::setValue(int row, const QString& value, Tone tone, double fraction) {
    Row& shown = rows_.at(static_cast<size_t>(row));
    if (shown.tone != tone)
        shown.icon->setIcon(shown.icon_name, [tone] { return iconColor(tone); });
    shown.tone = tone;
    if (shown.value->text() != value) {
        shown.widget->setVisible(!value.isEmpty());
        shown.value->setText(value);
        shown.value->setAccessibleName(shown.name->text() + QStringLiteral(": ") + value);
    }
    shown.bar->setVisible(fraction >= 0);
    if (fraction >= 0)
        shown.bar->setValue(fraction, tone == Tone::kNeutral ? Tone::kAccent : tone, value);
}

void NumberRows::setHint(int row, const QString& hint) {
    const Row& shown = rows_.at(static_cast<size_t>(row));
    shown.hint->setText(hint);
    shown.hint->parentWidget()->setVisible(!hint.isEmpty());
}

QString NumberRows::value(int row) const {
    const Row& shown = rows_.at(static_cast<size_t>(row));
    return shown.widget->isHidden() ? QString() : shown.value->text();
}

}  // namespace noctule::ui
