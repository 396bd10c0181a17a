// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/result_side.h"

#include "ui/style/keys.h"
#include "ui/style/words.h"
#include "ui/views/review/process_takes_dialog.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/wizards/finding_list.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

ResultSide::ResultSide(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      findings_(new FindingList),
      words_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      save_(makeButton(ButtonKind::kPrimary, tr("Save and use"))),
      process_(makeButton(ButtonKind::kOutlined, tr("Process takes again"), "redo")),
      repeat_(makeButton(ButtonKind::kOutlined, tr("Repeat steps"), "loop")),
      leave_(makeButton(ButtonKind::kText, {})) {
    auto* column = makeColumn(this);
    column->addWidget(new ScrollArea(findings_), 1);
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {12, 8, 12, 12}, 8);
    foot_column->addWidget(words_->wrapped());
    foot_column->addWidget(save_);
    foot_column->addWidget(process_);
    auto* row = addRow(foot_column, 8);
    row->addWidget(repeat_);
    row->addStretch();
    row->addWidget(leave_);
    column->addWidget(foot);
    connect(save_, &QPushButton::clicked, this, &ResultSide::save);
    connect(process_, &QPushButton::clicked, this,
            [this] { ProcessTakesDialog(studio_, run_->result()->actor, window()).exec(); });
    connect(repeat_, &QPushButton::clicked, this, &ResultSide::repeatRequested);
    connect(leave_, &QPushButton::clicked, this, &ResultSide::leaveRequested);
}

void ResultSide::setRun(WizardRun* run) {
    run_ = run;
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &ResultSide::refresh);
    refresh();
}

void ResultSide::setWayBack(const QString& words) {
    leave_->setText(words);
}

void ResultSide::refresh() {
    if (!run_ || run_->phase() != WizardRun::Phase::kResult)
        return;
    findings_->setFindings(run_->result()->document.findings);
    const bool checks = run_->task() == WizardTask::kCheck;
    const bool bad = run_->result()->grade() == Grade::kNotUsable;
    const QString undo = keysText(Keys::keyOf("window/undo", QKeySequence("Ctrl+Z")));
    save_->setVisible(!checks && !run_->isSaved());
    process_->setVisible(!checks && run_->isInUse() && studio_.session().isOpen() &&
                         !studio_.session().session().takes.empty());
    save_->setText(bad ? tr("Save and use it anyway") : tr("Save and use"));
    // What is filled is what is advised.
    const bool repeats = bad && !checks && !run_->isSaved() && run_->guide();
    save_->setKind(repeats ? ButtonKind::kOutlined : ButtonKind::kPrimary);
    repeat_->setKind(repeats ? ButtonKind::kPrimary : ButtonKind::kOutlined);
    repeat_->setVisible(!run_->isSaved() && run_->guide());
    if (run_->isSaved())
        words_->setText(
            run_->isInUse()
                ? tr("Saved and in use. New takes are made with it; undo with %1.").arg(undo)
                : tr("Saved. Takes are made with another calibration now; step Calibrate has the list."));
    else if (checks)
        words_->setText(tr("Nothing is changed by a check."));
    else if (bad)
        words_->setText(
            tr("Takes made with it would be wrong where the cards say so. Repeat what is named."));
    else
        words_->setText(tr("Will be saved as %1, and later takes are made with it; undo with %2.")
                            .arg(studio_.calibrations().nextName(keyOf(run_->task())), undo));
}

void ResultSide::save() {
    if (const QString why = run_->save(); !why.isEmpty())
        words_->setText(why);
}

}  // namespace noctule::ui
