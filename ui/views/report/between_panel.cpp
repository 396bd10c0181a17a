// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/between_panel.h"

#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {

BetweenPanel::BetweenPanel(ReviewContext& review, QWidget* parent)
    : QWidget(parent), review_(review), column_(makeColumn(this, {12, 8, 12, 8}, 4)) {}

/// The rows of the pair that begins at `first`: its people follow each other.
QWidget* BetweenPanel::tableOf(const std::vector<BetweenEvaluation>& found, size_t first) const {
    auto* table = new QWidget;
    auto* column = makeColumn(table, {}, 4);
    const BetweenEvaluation& pair = found[first];
    column->addWidget(new SectionHeader(
        tr("Between %1 and %2").arg(QString::fromStdString(pair.a), QString::fromStdString(pair.b)),
        tr("error, rms")));
    auto* rows = new FormRows;
    if (!pair.observed) {
        rows->addValue(tr("Distances"), tr("not observed"));
        column->addWidget(rows);
        return table;
    }
    for (size_t i = first; i < found.size() && found[i].a == pair.a && found[i].b == pair.b; ++i) {
        const BetweenEvaluation& one = found[i];
        rows->addValue(tr("%1 to %2").arg(jointName(one.from), jointName(one.to, NameCase::kInside)),
                       millimetresText(one.rms_mm / 1000));
        if (one.rms_near_mm)
            rows->addValue(tr("… nearer than 0.3 m"), millimetresText(*one.rms_near_mm / 1000));
    }
    rows->addValue(tr("Facing each other"), degreesText(radians(pair.heading_deg)));
    column->addWidget(rows);
    return table;
}

void BetweenPanel::refresh() {
    delete content_;
    content_ = nullptr;
    TakeDocument& take = review_.take();
    const auto found = take.isOfSeveral() && take.shownRun() >= 0 ? take.between() : nullptr;
    setVisible(found != nullptr);
    if (!found)
        return;
    content_ = new QWidget;
    auto* column = makeColumn(content_, {}, 8);
    for (size_t i = 0; i < found->size(); ++i)
        if (i == 0 || (*found)[i].a != (*found)[i - 1].a || (*found)[i].b != (*found)[i - 1].b)
            column->addWidget(tableOf(*found, i));
    if (found->empty()) {
        auto* hint = new Label(tr("How well distances between the performers are known is told against a "
                                  "reference of each of them."),
                               TextRole::kSecondary, Ink::kHint);
        column->addWidget(new SectionHeader(tr("Between the performers")));
        column->addWidget(hint->wrapped());
    }
    column_->addWidget(content_);
}

}  // namespace noctule::ui
