// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/attach_dialog.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QFileInfo>

#include "core/processing/outside_files.h"
#include "ui/views/review/choice_row.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {

AttachDialog::AttachDialog(const TakeOverview& overview, const QString& path, QWidget* parent)
    : DialogFrame(tr("Attach %1").arg(QFileInfo(path).fileName()),
                  tr("Another system's recording of the same performance goes into the take."), tr("Attach"),
                  parent),
      path_(path),
      is_positions_(holdsPlacesOnly(path.toStdString())),
      has_reference_(overview.has_reference),
      has_external_root_(overview.has_external_root),
      has_result_(!overview.runs.empty()) {
    using enum ChoiceRow::Kind;
    setWide(480);
    auto* choices = new QWidget;
    auto* column = makeColumn(choices, {}, 12);
    const auto alternatives = [this, column](const QString& title, ChoiceRow* first, ChoiceRow* second) {
        column->addSpacing(4);
        column->addWidget(new Label(title, TextRole::kSection, Ink::kValue, true));
        auto* group = new QButtonGroup(this);
        for (ChoiceRow* row : {first, second}) {
            column->addWidget(row);
            group->addButton(row->button());
            connect(row->button(), &QAbstractButton::toggled, this, &AttachDialog::refresh);
        }
    };
    as_reference = new ChoiceRow(kRadio, tr("Reference"), tr("What results are compared with."));
    as_external_root =
        new ChoiceRow(kRadio, tr("External root"), tr("Hips that processing with root given follows."));
    align_auto =
        new ChoiceRow(kRadio, tr("Found by motion"), tr("Where its movements match the last result best."));
    align_given =
        new ChoiceRow(kRadio, tr("It begins at"), tr("Milliseconds of the take's clock; may be negative."));
    milliseconds = new QDoubleSpinBox;
    milliseconds->setRange(-86400e3, 86400e3);
    milliseconds->setDecimals(1);
    milliseconds->setSuffix(tr(" ms"));
    milliseconds->setAccessibleName(tr("Begin of the recording in milliseconds"));
    replaces_ = new Label({}, TextRole::kSecondary, Ink::kWarn);

    alternatives(tr("Use as"), as_reference, as_external_root);
    alternatives(tr("Time"), align_auto, align_given);
    auto* indented = addRow(column, 0, {24, 0, 0, 0});
    indented->addWidget(milliseconds);
    indented->addStretch();
    column->addWidget(replaces_->wrapped());
    content()->addWidget(new ScrollArea(choices), 1);

    if (is_positions_)
        as_reference->setDisabledBecause(
            tr("Positions do not say how limbs are twisted; give a BVH file for that."));
    if (is_positions_ || !has_result_)
        align_auto->setDisabledBecause(is_positions_
                                           ? tr("Positions cannot be aligned by themselves.")
                                           : tr("Process the take first: its result is what motion is "
                                                "matched with."));
    (is_positions_ ? as_external_root : as_reference)->setChecked(true);
    (is_positions_ || !has_result_ ? align_given : align_auto)->setChecked(true);
    refresh();
}

void AttachDialog::refresh() {
    milliseconds->setEnabled(align_given->isChecked());
    const bool reference = as_reference->isChecked();
    const bool replaces = reference ? has_reference_ : has_external_root_;
    replaces_->setText(reference ? tr("The take has a reference already. Attaching replaces it.")
                                 : tr("The take has an external root already. Attaching replaces it."));
    replaces_->setVisible(replaces);
    actionButton()->setText(replaces ? tr("Replace") : tr("Attach"));
}

AttachChoice AttachDialog::choice() const {
    AttachChoice choice;
    choice.path = path_;
    choice.as = as_reference->isChecked() ? AttachAs::kReference : AttachAs::kExternalRoot;
    if (align_given->isChecked())
        choice.shift_s = milliseconds->value() / 1000;
    choice.overwrite = choice.as == AttachAs::kReference ? has_reference_ : has_external_root_;
    return choice;
}

}  // namespace noctule::ui
