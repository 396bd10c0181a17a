// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_boards.h"

#include <QVBoxLayout>
#include <utility>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/wizards/board_table.h"
#include "ui/wizards/wizard_words.h"

namespace noctule::ui {

WizardBoards::WizardBoards(QWidget* parent)
    : QWidget(parent),
      count_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      words_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      table_(new BoardTable),
      repeat_(makeButton(ButtonKind::kOutlined, {}, "loop")),
      skip_(makeButton(ButtonKind::kOutlined, {})),
      back_(makeButton(ButtonKind::kText, tr("Back"))),
      enough_(makeButton(ButtonKind::kText, tr("Calibrate with what there is"))) {
    auto* column = makeColumn(this);
    auto* scrolled = new QWidget;
    auto* scrolled_column = makeColumn(scrolled, {0, 8, 0, 8});
    auto* head = new QWidget;
    makeRow(head, {12, 0, 12, 0})->addWidget(count_);
    scrolled_column->addWidget(head);
    scrolled_column->addWidget(table_);
    scrolled_column->addStretch();
    column->addWidget(new ScrollArea(scrolled), 1);
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {12, 8, 12, 12}, 8);
    foot_column->addWidget(words_->wrapped());
    for (const auto& [first, second] : {std::pair{repeat_, back_}, std::pair{skip_, enough_}}) {
        auto* row = addRow(foot_column, 8);
        row->addWidget(first);
        row->addStretch();
        row->addWidget(second);
    }
    column->addWidget(foot);
    repeat_->setShortcutHint(Qt::Key_R);
    skip_->setShortcutHint(Qt::Key_S);
    back_->setToolTip(tr("The step that was taken last, once more (Backspace)"));
    connect(repeat_, &QPushButton::clicked, this, &WizardBoards::repeatStep);
    connect(skip_, &QPushButton::clicked, this, &WizardBoards::skipBoard);
    connect(back_, &QPushButton::clicked, this, [this] {
        if (run_)
            run_->goBack();
    });
    connect(enough_, &QPushButton::clicked, this, [this] {
        if (run_)
            run_->solveNow();
    });
    connect(table_, &BoardTable::boardChosen, this, &WizardBoards::refresh);
}

void WizardBoards::setRun(WizardRun* run) {
    run_ = run;
    step_ = -1;
    table_->setRun(run);
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &WizardBoards::refresh);
    connect(run, &WizardRun::guided, this, &WizardBoards::refresh);
    refresh();
}

void WizardBoards::setStep(int step) {
    step_ = step;
    refresh();
}

/// The one that is chosen, else the one that is in the way.
int WizardBoards::boardToSkip() const {
    if (!run_ || !run_->guide())
        return -1;
    const Guidance& now = run_->guide()->guidance();
    return table_->chosen() >= 0 ? table_->chosen() : now.hindering > 0 ? now.board : -1;
}

void WizardBoards::skipBoard() {
    const int board = boardToSkip();
    if (board >= 0)
        run_->skip(board, !run_->guide()->isSkipped(board));
}

void WizardBoards::repeatStep() {
    if (!run_ || !run_->guide())
        return;
    if (step_ >= 0)
        run_->repeat(step_);
    else
        run_->goBack();
}

void WizardBoards::refresh() {
    if (!run_ || !run_->guide())
        return;
    const Guide& guide = *run_->guide();
    const int boards = static_cast<int>(run_->suit().boards.size());
    int done = 0;
    for (int step = 0; step < guide.stepCount(); ++step)
        for (int board = 0; board < boards; ++board)
            done += guide.isDone(step, board);
    count_->setText(tr("%1 of %2 steps").arg(done).arg(boards * guide.stepCount()));
    const int board = boardToSkip();
    const bool skipped = board >= 0 && guide.isSkipped(board);
    skip_->setText(board < 0 ? tr("Skip a board")
                   : skipped ? tr("Use board %1 again").arg(board + 1)
                             : tr("Skip board %1").arg(board + 1));
    skip_->setDisabledBecause(board < 0 ? tr("Choose a board in the table first.") : QString());
    repeat_->setText(step_ >= 0 ? tr("Repeat step %1").arg(step_ + 1) : tr("Repeat the last step"));
    const QString nothing = run_->canGoBack() ? QString() : tr("No step has been taken yet.");
    repeat_->setDisabledBecause(nothing);
    back_->setDisabledBecause(nothing);
    enough_->setDisabledBecause(nothing);
    enough_->setVisible(guide.stepCount() > 1 || guide.isFinished());
    const QString cost = board >= 0 ? costOfSkipping(*run_, board) : QString();
    words_->setText(!run_->trouble().isEmpty()         ? run_->trouble()
                    : skipped || table_->chosen() >= 0 ? cost
                                                       : QString());
}

}  // namespace noctule::ui
