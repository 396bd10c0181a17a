// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_results_panel.h"

#include <QFileInfo>

#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {
namespace {

Tone outcomeTone(const ExportOutcome& outcome) {
    if (outcome.error || !outcome.check.ok())
        return Tone::kError;
    return outcome.check.silent.empty() && outcome.check.floorRemedy() == FloorRemedy::kNone ? Tone::kOk
                                                                                             : Tone::kWarn;
}

/// All is told of the first file and of those with faults, of others what may differ.
void addFacts(FormRows& rows, const ExportCheck& check, bool in_full) {
    if (check.is_picture) {
        rows.addValue(ExportResultsPanel::tr("Size"), pictureInWords(check));
        return;
    }
    if (in_full || !check.ok()) {
        if (check.has_figure) {
            rows.addValue(ExportResultsPanel::tr("Height"), heightInWords(check));
            rows.addValue(ExportResultsPanel::tr("Facing"), facingInWords(check));
        }
        rows.addValue(ExportResultsPanel::tr("Joints"),
                      ExportResultsPanel::tr("%1 of %2").arg(check.joints).arg(check.expected_joints));
    }
    rows.addValue(ExportResultsPanel::tr("Largest difference"), differenceInWords(check));
}

}  // namespace

ExportResultsPanel::ExportResultsPanel(QWidget* parent)
    : QWidget(parent),
      empty_(new EmptyState(tr("Written files are listed here, each with its check."))),
      results_(new QWidget),
      content_(new QWidget),
      cards_(new QWidget),
      area_(new ScrollArea(content_)),
      verdict_(new VerdictHeader),
      cards_column_(makeColumn(cards_, {}, 8)),
      save_(makeButton(ButtonKind::kText, tr("Save the check as text"), "note")) {
    auto* outer = makeColumn(this);
    outer->addWidget(empty_, 1);
    outer->addWidget(results_, 1);
    auto* column = makeColumn(content_, {20, 16, 20, 20}, 12);
    verdict_->setCompact(true);
    column->addWidget(verdict_);
    column->addWidget(cards_);
    auto* links = addRow(column, 8);
    links->addWidget(save_);
    links->addStretch();
    column->addStretch();
    keepMaximumWidth(*content_, 640);
    makeColumn(results_)->addWidget(area_);
    connect(save_, &QPushButton::clicked, this, &ExportResultsPanel::saveWanted);
    clear();
}

int ExportResultsPanel::cardCount() const {
    return cards_column_->count();
}

void ExportResultsPanel::setScrolls(bool scrolls) {
    if (scrolls == (area_->widget() == content_))
        return;
    if (scrolls) {
        area_->setWidget(content_);
        content_->setAutoFillBackground(false);  // Qt fills what it scrolls
    } else {
        area_->takeWidget();
        content_->setMinimumHeight(0);  // of the area's width
        results_->layout()->addWidget(content_);
    }
    content_->show();
    area_->setVisible(scrolls);
}

void ExportResultsPanel::clear() {
    earlier_.clear();
    latest_.clear();
    showCards({});
    results_->hide();
    empty_->show();
}

void ExportResultsPanel::showCards(const ExportResults& latest) {
    clearWidgets(*cards_column_);
    const Kept kept = latest_.empty() ? Kept::kNo : Kept::kYes;
    for (size_t i = 0; i < latest.outcomes.size(); ++i)
        cards_column_->addWidget(makeCard(latest.outcomes[i], i == 0, kept));
    if (!earlier_.empty())
        cards_column_->addWidget(new SectionHeader(tr("Written before")));
    for (const ExportOutcome& outcome : earlier_)
        cards_column_->addWidget(makeCard(outcome, false, Kept::kYes));
}

void ExportResultsPanel::setResults(const ExportResults& results, bool is_trial) {
    earlier_.insert(earlier_.begin(), latest_.begin(), latest_.end());
    latest_.clear();
    if (!is_trial)
        latest_ = results.outcomes;
    empty_->hide();
    results_->show();
    const int written = results.written(), faulty = results.faulty();
    const auto remarked =
        std::count_if(results.outcomes.begin(), results.outcomes.end(),
                      [](const ExportOutcome& outcome) { return outcomeTone(outcome) == Tone::kWarn; });
    const Tone tone = faulty > 0 ? Tone::kError : remarked > 0 ? Tone::kWarn : Tone::kOk;
    const QString title = is_trial ? tr("One frame written, read back and deleted")
                                   : tr("%n files written and read back", nullptr, written);
    QString text = tr("Each file was opened again and compared with its take.");
    if (faulty > 0)
        text = tr("Each file was opened again and compared with its take. %n are not what they should be.",
                  nullptr, faulty);
    else if (remarked > 0)
        text = tr("Each file was opened again and compared with its take. %n have something you should know.",
                  nullptr, static_cast<int>(remarked));
    verdict_->setVerdict(tone, title, text);
    showCards(results);
    save_->setVisible(!is_trial);
}

QWidget* ExportResultsPanel::makeCard(const ExportOutcome& outcome, bool in_full, Kept kept) {
    const ExportCheck& check = outcome.check;
    const Tone tone = outcomeTone(outcome);
    auto* card = new Card;
    auto* column = makeColumn(card, {12, 10, 12, 12}, 8);
    auto* head = addRow(column, 8);
    head->addWidget(new IconLabel(iconOf(tone), [tone] { return colorOf(tone); }));
    const QString file = QFileInfo(QString::fromStdString(outcome.path)).fileName();
    const bool names_take = outcome.in_one_file && !outcome.take.isEmpty();
    auto* name = new Label(names_take ? tr("%1: %2").arg(file, outcome.take) : file, TextRole::kBody,
                           Ink::kValue, true);
    name->setToolTip(QString::fromStdString(outcome.path));
    head->addWidget(name->selectable(), 1);
    if (outcome.error) {
        column->addWidget((new Label(coreWords(outcome.error->text()), TextRole::kSecondary, Ink::kError))
                              ->wrapped()
                              ->selectable());
        return card;
    }
    head->addWidget(new Label(
        tr("%1 frames, %2").arg(countText(static_cast<qint64>(check.frames)), bytesText(check.bytes)),
        TextRole::kSecondary, Ink::kLabel));
    auto* rows = new FormRows(124);
    if (!outcome.result.isEmpty())
        rows->addValue(tr("Result"), outcome.result);
    addFacts(*rows, check, in_full);
    auto* indented = addRow(column, 0, {24, 0, 0, 0});
    indented->addWidget(rows);
    const auto addLine = [&](const QString& text, Ink ink) {
        auto* line = addRow(column, 0, {24, 0, 0, 0});
        line->addWidget((new Label(text, TextRole::kSecondary, ink))->wrapped()->selectable());
    };
    if (const QString below = belowFloorInWords(check); !below.isEmpty())
        addLine(below, Ink::kWarn);
    for (const SilentBoard& silent : check.silent)
        addLine(silenceInWords(silent), Ink::kWarn);
    for (const std::string& held : check.held)
        addLine(coreWords(held), Ink::kLabel);
    for (const std::string& fault : check.faults)
        addLine(coreWords(fault), Ink::kError);
    if (kept == Kept::kYes) {
        auto* open = makeButton(ButtonKind::kText, tr("Open"));
        open->setAccessibleName(tr("Open %1").arg(file));
        connect(open, &QPushButton::clicked, this,
                [this, path = QString::fromStdString(outcome.path)] { emit openWanted(path); });
        addRow(column, 0, {12, 0, 0, 0})->addWidget(open, 0, Qt::AlignLeft);
    }
    return card;
}

}  // namespace noctule::ui
