// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_panel.h"

#include "core/math/conventions.h"
#include "core/motion/foot_contacts.h"
#include "ui/style/keys.h"
#include "ui/style/words.h"
#include "ui/views/report/between_panel.h"
#include "ui/views/report/joint_table.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/value_card.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {

namespace {
constexpr size_t kMostProblems = 3;
/// Simulated takes of the nominal scenario have 2 to 5 mm, where the detector's noise is 3.
constexpr double kGoodMedian_m = 0.01;
}  // namespace

ReportPanel::ReportPanel(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      verdict_(new VerdictHeader),
      empty_(new EmptyState({}, tr("Process"), "redo")),
      judged_(new QWidget),
      problems_(new QWidget),
      problems_column_(makeColumn(problems_, {12, 0, 12, 4}, 8)),
      more_problems_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      between_(new BetweenPanel(review)),
      joints_(new JointTable(review.selection())),
      full_report_(makeButton(ButtonKind::kText, tr("Open full report"))),
      export_(makeButton(ButtonKind::kPrimary, tr("Export"), "export")) {
    followKey(*export_, "window/export", QKeySequence("Ctrl+E"),
              [this](const QKeySequence& key) { export_->setShortcutHint(key); });
    auto* column = makeColumn(this);
    auto* content = new QWidget;
    auto* parts = makeColumn(content);
    auto* head = new QWidget;
    auto* head_column = makeColumn(head, {12, 16, 12, 8}, 4);
    head_column->addWidget(verdict_);
    auto* link = addRow(head_column);
    link->addWidget(full_report_);
    link->addStretch();
    parts->addWidget(head);
    parts->addWidget(empty_);
    parts->addWidget(judged_);
    parts->addStretch();
    auto* inner = makeColumn(judged_);
    inner->addWidget(problems_);
    inner->addWidget(makeNumbers());
    inner->addWidget(between_);
    inner->addWidget(new Divider);
    inner->addWidget(joints_);
    auto* rest = new QWidget;
    auto* rest_column = makeColumn(rest, {12, 12, 12, 16});
    auto* rows = new FormRows;
    slide_ = rows->addValue(tr("Foot slide"), {});
    drift_ = rows->addValue(tr("Drift of heading"), {});
    contacts_ = rows->addValue(tr("Contacts"), {});
    rest_column->addWidget(rows);
    inner->addWidget(rest);
    column->addWidget(new ScrollArea(content), 1);

    column->addWidget(new Divider);
    auto* foot = new QWidget;
    makeColumn(foot, {12, 12, 12, 12})->addWidget(export_);
    column->addWidget(foot);

    connect(full_report_, &QPushButton::clicked, this, &ReportPanel::fullReportWanted);
    connect(export_, &QPushButton::clicked, this, &ReportPanel::exportWanted);
    connect(empty_, &EmptyState::activated, this, &ReportPanel::processingWanted);
    for (const auto signal :
         {&TakeDocument::opened, &TakeDocument::runsChanged, &TakeDocument::reportChanged})
        connect(&review.take(), signal, this, &ReportPanel::refresh);
    connect(&review.take(), &TakeDocument::processingChanged, this, &ReportPanel::refresh);
    connect(&review.take(), &TakeDocument::torn, this, &ReportPanel::refresh);
    connect(&review.take(), &TakeDocument::motionChanged, this, &ReportPanel::showFeet);
    refresh();
}

QWidget* ReportPanel::makeNumbers() {
    auto* numbers = new QWidget;
    auto* grid = makeGrid(numbers, {12, 0, 12, 16}, 8);
    const QString captions[] = {
        {},
        tr("of time backed\nby ranges"),
        tr("range residual,\nmedian; good: under %1").arg(millimetresText(kGoodMedian_m, 0)),
        {}};
    for (int i = 0; i < 4; ++i) {
        cards_[static_cast<size_t>(i)] = new ValueCard(kNoValue, captions[i]);
        grid->addWidget(cards_[static_cast<size_t>(i)], i / 2, i % 2);
        grid->setColumnStretch(i % 2, 1);
    }
    return numbers;
}

void ReportPanel::refresh() {
    TakeDocument& take = review_.take();
    const auto overview = take.overview();
    const bool has_run = overview && take.shownRun() >= 0;
    const auto verdict = has_run ? take.verdict() : nullptr;
    judged_->setVisible(verdict != nullptr);
    between_->refresh();
    verdict_->setVisible(has_run);
    empty_->setVisible(!has_run);
    const QString no_report = !overview ? tr("Open a take first.") : tr("Process the take first.");
    full_report_->setVisible(has_run);
    export_->setDisabledBecause(has_run ? QString() : no_report);
    if (!overview)
        empty_->setSentence(tr("The report of the open take will be here."));
    else if (take.processing())
        empty_->setSentence(tr("The take is being processed. Its verdict will be here."));
    else if (!has_run)
        empty_->setSentence(tr("The take is recorded but not processed yet. Its verdict will be here."));
    if (empty_->button())
        empty_->button()->setVisible(overview && !take.processing());
    if (verdict)
        showVerdict(*verdict);
    else if (has_run && !take.problem().isEmpty())
        verdict_->setVerdict(Tone::kWarn, tr("Not judged"), take.problem());
    else if (has_run)
        verdict_->setVerdict(Tone::kNeutral, tr("Judging the take"),
                             tr("Its sensors and results are being compared."));
    if (has_run && take.isDamaged())
        verdict_->setVerdict(Tone::kError, tr("The file is damaged"),
                             tr("Not all of the take can be read. The numbers are of what could be."));
}

void ReportPanel::showVerdict(const TakeVerdict& verdict) {
    verdict_->setVerdict(toneOf(verdict.grade), gradeInWords(verdict.grade), gradeExplained(verdict));
    showProblems(problemsInWords(verdict, *review_.take().overview()));
    cards_[0]->setValue(verdict.mean_error_deg ? degreesText(radians(*verdict.mean_error_deg)) : kNoValue);
    cards_[0]->setCaption(verdict.mean_error_deg ? tr("mean joint error\nagainst the reference")
                                                 : tr("mean joint error,\nno reference"));
    for (const size_t of_ranges : {1, 2})
        cards_[of_ranges]->setVisible(review_.take().hasSources());
    cards_[1]->setValue(percentText(verdict.backed_share));
    cards_[2]->setValue(verdict.residual_median_m ? millimetresText(*verdict.residual_median_m) : kNoValue);
    cards_[2]->setToolTip(
        verdict.residual_rms_m
            ? tr("Half of the ranges used miss the pose by less. Root mean square, which a few "
                 "echoes make large: %1.")
                  .arg(millimetresText(*verdict.residual_rms_m))
            : QString());
    cards_[3]->setValue(secondsText(verdict.hole_s, 2));
    cards_[3]->setCaption(verdict.hole_s > 0
                              ? tr("without signal,\nlongest %1").arg(secondsText(verdict.longest_hole_s, 2))
                              : tr("without signal,\nno gaps"));
    joints_->setVerdict(review_.take().verdict());
    drift_->setText(verdict.yaw_drift_deg_per_min
                        ? tr("%1 per minute").arg(degreesText(radians(*verdict.yaw_drift_deg_per_min)))
                        : tr("unknown without reference"));
    showFeet();
}

void ReportPanel::showProblems(const std::vector<ProblemWords>& problems) {
    while (QLayoutItem* item = problems_column_->takeAt(0)) {
        if (item->widget() != more_problems_)
            delete item->widget();
        delete item;
    }
    for (const ProblemWords& problem : problems) {
        if (static_cast<size_t>(problems_column_->count()) == kMostProblems)
            break;
        auto* card = new ProblemCard(problem.tone, problem.title, problem.text);
        if (!problem.action.isEmpty())
            connect(card->addAction(problem.action), &QPushButton::clicked, this,
                    [this, problem] { goTo(problem); });
        problems_column_->addWidget(card);
    }
    const int more = static_cast<int>(problems.size()) - problems_column_->count();
    more_problems_->setText(tr("%n more in the full report", nullptr, more));
    more_problems_->setVisible(more > 0);
    problems_column_->addWidget(more_problems_);
    problems_->setVisible(!problems.empty());
}

void ReportPanel::showFeet() {
    const auto feet =
        review_.take().isOpen() && review_.take().shownRun() >= 0 ? review_.take().contacts() : nullptr;
    size_t found = 0;
    if (feet)
        for (const FootContacts& foot : *feet)
            found += foot.contacts.size();
    slide_->setText(found > 0 ? tr("%1 per step").arg(millimetresText(meanSlide_m(*feet), 0)) : kNoValue);
    const int count = static_cast<int>(found);
    const bool by_hand = feet && review_.take().overview()->contacts_edited;
    contacts_->setText(!feet     ? kNoValue
                       : by_hand ? tr("%n, set by hand", nullptr, count)
                                 : tr("%n found", nullptr, count));
}

void ReportPanel::goTo(const ProblemWords& problem) {
    if (problem.with_gyroscopes)
        emit gyroscopesWanted();
    else if (problem.processes)
        emit processingWanted();
    if (!problem.joint.isEmpty())
        review_.selection().setJoint(problem.joint);
    if (problem.board >= 0)
        review_.selection().setBoard(problem.board);
    if (problem.time_s >= 0)
        review_.time().setTime(problem.time_s);
}

}  // namespace noctule::ui
