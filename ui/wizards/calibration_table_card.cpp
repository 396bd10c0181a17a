// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/calibration_table_card.h"

#include <QGridLayout>

#include "ui/language/core_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {

CalibrationTableCard::CalibrationTableCard(const CalibrationTable& table, QWidget* parent) : Card(parent) {
    auto* column = makeColumn(this, {16, 12, 16, 12}, 8);
    column->addWidget(new SectionHeader(coreWords(table.title)));
    column->addWidget((new Label(coreWords(table.lead), TextRole::kSecondary, Ink::kHint))->wrapped());
    auto* cells = new QWidget;
    auto* grid = makeGrid(cells, {}, 6);
    const auto add = [grid](const std::string& text, int row, int column_index, Ink ink, TextRole role) {
        auto* cell = (new Label(coreWords(text), role, ink))->wrapped();  // a narrow page breaks them
        cell->setAlignment((column_index == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        grid->addWidget(cell, row, column_index);
    };
    for (size_t i = 0; i < table.columns.size(); ++i)
        add(table.columns[i], 0, static_cast<int>(i), Ink::kHint, TextRole::kCaption);
    for (size_t row = 0; row < table.rows.size(); ++row)
        for (size_t i = 0; i < table.rows[row].size(); ++i)
            add(table.rows[row][i], static_cast<int>(row) + 1, static_cast<int>(i),
                i == 0 ? Ink::kValue : Ink::kLabel, TextRole::kSecondary);
    column->addWidget(cells);
}

CalibrationTable named(CalibrationTable table, const PartNames& names) {
    for (auto& row : table.rows)
        if (!row.empty() && !table.columns.empty())
            names.apply(table.columns.front(), row.front());
    return table;
}

}  // namespace noctule::ui
