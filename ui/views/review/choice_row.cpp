// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/choice_row.h"

#include <QCheckBox>
#include <QRadioButton>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

ChoiceRow::ChoiceRow(Kind kind, const QString& name, const QString& meaning, QWidget* parent)
    : QWidget(parent),
      button_(kind == Kind::kCheck ? static_cast<QAbstractButton*>(new QCheckBox(name))
                                   : new QRadioButton(name)),
      meaning_label_(new Label(meaning, TextRole::kSecondary, Ink::kHint)),
      meaning_(meaning) {
    auto* column = makeColumn(this);
    column->addWidget(button_);
    // Under the words, not under the box.
    auto* below = addRow(column, 0, {24, 0, 0, 0});
    below->addWidget(meaning_label_->wrapped());
    // Radio buttons of several rows have several parents: their group keeps them apart.
    button_->setAutoExclusive(false);
    button_->setAccessibleDescription(meaning);
    meaning_label_->setVisible(!meaning.isEmpty());
}

bool ChoiceRow::isChecked() const {
    return button_->isChecked();
}

void ChoiceRow::setChecked(bool checked) {
    button_->setChecked(checked);
}

void ChoiceRow::setDisabledBecause(const QString& reason) {
    button_->setEnabled(reason.isEmpty());
    const QString& words = reason.isEmpty() ? meaning_ : reason;
    meaning_label_->setText(words);
    meaning_label_->setVisible(!words.isEmpty());
    button_->setAccessibleDescription(words);
}

}  // namespace noctule::ui
