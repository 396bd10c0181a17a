// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/form_rows.h"

#include <QGridLayout>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

FormRows::FormRows(int label_width, QWidget* parent) : QWidget(parent), label_width_(label_width) {
    grid_ = new QGridLayout(this);
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setColumnStretch(1, 1);
    const auto restyle = [this] {
        const Theme& theme = Theme::get();
        grid_->setHorizontalSpacing(theme.px(12));
        grid_->setVerticalSpacing(theme.px(8));
        grid_->setColumnMinimumWidth(0, theme.px(label_width_));
    };
    connect(&Theme::get(), &Theme::changed, this, restyle);
    restyle();
}

int FormRows::nextRow() const {
    return grid_->count() == 0 ? 0 : grid_->rowCount();
}

/// An empty cell keeps the distance between the columns where no row has a label. One is enough: in every row
/// it would keep the distance between rows of a row that is hidden.
void FormRows::addInSecondColumn(QWidget* widget) {
    const int row = nextRow();
    if (row == 0)
        grid_->addWidget(new QWidget, row, 0);
    grid_->addWidget(widget, row, 1);
}

Label* FormRows::addRow(const QString& label, QWidget* control) {
    const int row = nextRow();
    auto* words = new Label(label, TextRole::kBody, Ink::kLabel);
    words->setBuddy(control);
    if (control->accessibleName().isEmpty())
        control->setAccessibleName(label);
    grid_->addWidget(words, row, 0);
    grid_->addWidget(control, row, 1);
    return words;
}

void FormRows::addControl(QWidget* control) {
    addInSecondColumn(control);
}

Label* FormRows::addHint(const QString& text) {
    auto* hint = (new Label(text, TextRole::kSecondary, Ink::kHint))->wrapped();
    addInSecondColumn(hint);
    return hint;
}

Label* FormRows::addValue(const QString& label, const QString& value) {
    const int row = nextRow();
    auto* words = new Label(label, TextRole::kSecondary, Ink::kLabel);
    auto* number = new Label(value, TextRole::kSecondary, Ink::kValue);
    number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    words->setBuddy(number);
    grid_->addWidget(words, row, 0);
    grid_->addWidget(number, row, 1);
    return number;
}

int FormRows::widestLabel() const {
    int widest = 0;
    for (int row = 0; row < grid_->rowCount(); ++row)
        if (QLayoutItem* label = grid_->itemAtPosition(row, 0))
            widest = std::max(widest, label->widget()->sizeHint().width());
    return widest;
}

void FormRows::alignLabels(const std::vector<FormRows*>& forms) {
    const auto align = [forms] {
        int width = 0;
        for (const FormRows* form : forms)
            width = std::max({width, Theme::get().px(form->label_width_), form->widestLabel()});
        for (const FormRows* form : forms)
            form->grid_->setColumnMinimumWidth(0, width);
    };
    connect(&Theme::get(), &Theme::changed, forms.front(), align);  // after their own sizes
    align();
}

}  // namespace noctule::ui
