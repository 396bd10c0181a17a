// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_result.h"

#include <QHBoxLayout>
#include <QScrollBar>
#include <QVBoxLayout>
#include <numeric>

#include "core/sensor_calibration/field_turn.h"
#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/card.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/value_card.h"
#include "ui/widgets/verdict_header.h"
#include "ui/wizards/calibration_table_card.h"
#include "ui/wizards/error_plot.h"
#include "ui/wizards/field_drawing.h"

namespace noctule::ui {
namespace {

Tone toneOfGrade(Grade grade) {
    switch (grade) {
        case Grade::kGood:
            return Tone::kOk;
        case Grade::kUsable:
            return Tone::kWarn;
        case Grade::kNotUsable:
            return Tone::kError;
        case Grade::kUnknown:
            break;
    }
    return Tone::kNeutral;
}

double meanOf(const CalibrationErrors& errors, std::vector<double> CalibrationErrors::Row::*values) {
    double sum = 0;
    size_t count = 0;
    for (const CalibrationErrors::Row& row : errors.rows) {
        sum = std::accumulate((row.*values).begin(), (row.*values).end(), sum);
        count += (row.*values).size();
    }
    return count > 0 ? sum / static_cast<double>(count) : -1;
}

/// "mean 0.12 mg (blue), before 310 mg (grey)"
QString meansOf(const CalibrationErrors& errors) {
    const QString unit = coreWords(errors.unit);
    const auto inUnit = [&unit](double value) {
        return numberText(value, value < 10 ? 2 : 0) + (unit == "\u00b0" ? unit : ' ' + unit);
    };
    const double after = meanOf(errors, &CalibrationErrors::Row::after);
    const double before = meanOf(errors, &CalibrationErrors::Row::before);
    if (after < 0)
        return {};
    return before < 0 ? WizardResult::tr("mean %1").arg(inUnit(after))
                      : WizardResult::tr("mean %1 (blue), with the calibration before %2 (grey)")
                            .arg(inUnit(after), inUnit(before));
}

}  // namespace

WizardResult::WizardResult(QWidget* parent) : QWidget(parent), header_(new VerdictHeader), content_(nullptr) {
    header_->setRole(TextRole::kVerdict);
    auto* content = new QWidget;
    content_ = makeColumn(content, {28, 20, 28, 20}, 12);
    scroll_ = new ScrollArea(content);
    makeColumn(this)->addWidget(scroll_);
    content_->addWidget(header_);
}

CalibrationDocument WizardResult::named(CalibrationDocument document, const PartNames& names) {
    // The errors are those of the parts in the first table.
    const bool has_table = !document.tables.empty() && !document.tables.front().columns.empty();
    const std::string column = has_table ? document.tables.front().columns.front() : std::string();
    for (CalibrationTable& table : document.tables)
        table = ui::named(std::move(table), names);
    if (document.errors)
        for (CalibrationErrors::Row& row : document.errors->rows)
            names.apply(column, row.name);
    return document;
}

void WizardResult::setDocument(const CalibrationDocument& document, const PartNames& names) {
    clearWidgets(*content_, 1);
    fill(named(document, names));
    scroll_->verticalScrollBar()->setValue(0);
}

void WizardResult::addSphere(const FieldSphere& sphere) {
    auto* drawing = new FieldDrawing;
    drawing->show(sphere, sphere.share() < FieldTurnLimits::kEnoughShare ? sphere.emptySide() : std::nullopt);
    keepSize(*drawing, 0, 330);
    // Above the stretch and the tables.
    content_->insertWidget(std::min(3, content_->count() - 1), drawing);
}

void WizardResult::fill(const CalibrationDocument& document) {
    const Grade grade = gradeOf(document.findings);
    verdict_ = grade == Grade::kGood ? tr("Good") : grade == Grade::kUsable ? tr("Usable") : tr("Not usable");
    const bool is_judged = grade != Grade::kUnknown;
    if (!is_judged)
        verdict_ = coreWords(document.summary) + '.';
    header_->setVerdict(
        is_judged ? toneOfGrade(grade) : Tone::kWarn,
        is_judged ? QStringLiteral("%1. %2.").arg(verdict_, coreWords(document.summary)) : verdict_,
        document.findings.empty()
            ? tr("Nothing need be repeated.")
            : tr("%n thing(s) to look at.", nullptr, static_cast<int>(document.findings.size())));
    if (!document.numbers.empty()) {
        auto* numbers = new QWidget;
        auto* rows = makeColumn(numbers, {}, 8);
        // Four captions need two lines: beside each other they are wider than a page of large type.
        const size_t in_a_row = document.numbers.size() > 3 ? 2 : document.numbers.size();
        QHBoxLayout* row = nullptr;
        size_t placed = 0;
        for (const CalibrationNumber& number : document.numbers) {
            auto* card = new ValueCard;
            card->setValue(coreWords(number.value),
                           number.grade == Grade::kGood ? Tone::kNeutral : Tone::kWarn);
            card->setCaption(number.good.empty()
                                 ? coreWords(number.what)
                                 : QStringLiteral("%1\n%2").arg(coreWords(number.what),
                                                                tr("good: %1").arg(coreWords(number.good))));
            if (placed++ % in_a_row == 0)
                row = addRow(rows, 8);
            row->addWidget(card, 1);
        }
        content_->addWidget(numbers);
    }
    if (document.errors && !document.errors->rows.empty()) {
        auto* card = new Card;
        auto* column = makeColumn(card, {16, 12, 16, 12}, 8);
        column->addWidget(new SectionHeader(coreWords(document.errors->title)));
        column->addWidget(
            (new Label(meansOf(*document.errors), TextRole::kSecondary, Ink::kHint))->wrapped());
        auto* plot = new ErrorPlot;
        plot->setErrors(*document.errors);
        column->addWidget(plot);
        if (plot->hasBeyondScale())
            column->addWidget((new Label(tr("A triangle at the end of the scale: this error lies beyond it."),
                                         TextRole::kSecondary, Ink::kHint))
                                  ->wrapped());
        content_->addWidget(card);
    }
    for (const CalibrationTable& table : document.tables)
        content_->addWidget(new CalibrationTableCard(table));
    content_->addStretch();
}

}  // namespace noctule::ui
