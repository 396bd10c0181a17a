// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/live_pairs.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/part_names.h"
#include "ui/plots/confidence_legend.h"
#include "ui/plots/pair_columns.h"
#include "ui/style/lengths.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

constexpr double kNow_s = 0.2;  ///< three rounds
constexpr int kLeastRow = 16, kAroundRows = 52;

}  // namespace

LivePairs::LivePairs(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      grid_(new PairGrid),
      cell_(new ElidedLabel({}, TextRole::kSecondary, Ink::kLabel)) {
    auto* column = makeColumn(this, {16, 8, 16, 8}, 4);
    auto* head = addRow(column, 8);
    head->addWidget(new Label(tr("Pairs"), TextRole::kBody, Ink::kValue, true));
    head->addWidget(new Label(tr("confidence now, source by board"), TextRole::kSecondary, Ink::kHint));
    head->addStretch();
    head->addWidget(new ConfidenceLegend);
    column->addWidget(grid_, 1);
    column->addWidget(cell_);
    connect(&Theme::get(), &Theme::changed, this, &LivePairs::fitRows);
    capture.suits().follow(&SuitCheck::changed, this, [this] {
        if (isVisible())
            show(check().readiness());
    });
    connect(grid_, &PairGrid::chosen, this, [this](int, int board) {
        tellCell();
        emit boardChosen(board);
    });
}

void LivePairs::setBoard(int board) {
    if (board != grid_->currentColumn())
        grid_->setCurrent(board < 0 ? -1 : std::max(0, grid_->currentRow()), board);
    tellCell();
}

PairGridContent LivePairs::headings(const Readiness& readiness) const {
    const Suit& suit = check().suit().suit();
    PairGridContent content;
    for (size_t source = 0; source < suit.sources.size(); ++source) {
        const bool attention = std::ranges::any_of(readiness.problems, [&](const auto& problem) {
            return problem.source == static_cast<int>(source);
        });
        content.rows.push_back({tr("%1 %2", "number and place of a source")
                                    .arg(source + 1)
                                    .arg(sourcePlace(suit.sources[source], NameCase::kInside)),
                                sourceTitle(suit, static_cast<int>(source)), attention});
        content.row_notes.push_back(tr("%1 good", "pairs").arg(readiness.source_good_pairs[source]));
    }
    for (size_t board = 0; board < suit.boards.size(); ++board) {
        const auto state = readiness.boards[board].state;
        content.columns.push_back(
            {QString::number(board + 1), boardTitle(suit, static_cast<int>(board)),
             state == BoardReadiness::State::kSilent || state == BoardReadiness::State::kPoor});
    }
    content.groups = columnGroups(suit);
    return content;
}

PairCell LivePairs::cellOf(const Readiness& readiness, int source, int board) const {
    const QString name = pairName(check().suit().suit(), source, board);
    const auto frame = check().suit().frame();
    if (readiness.boards[static_cast<size_t>(board)].state == BoardReadiness::State::kSilent)
        return {PairCell::State::kLost, 0, tr("%1: the board sends nothing", "a pair").arg(name)};
    const PairHealth& pair = frame->health.pair(source, board);
    if (check().nothingSince().isValid() || !pair.age_s || *pair.age_s > kNow_s)
        return {PairCell::State::kSilent, 0, tr("%1: not heard", "a pair").arg(name)};
    return {PairCell::State::kHeard, pair.confidence,
            tr("%1: confidence %2, distance %3", "a pair")
                .arg(name, numberText(pair.confidence, 2), lengthText(pair.distance_m))};
}

void LivePairs::show(const Readiness& readiness) {
    const Suit& suit = check().suit().suit();
    const auto frame = check().suit().frame();
    const bool known = frame && readiness.boards.size() == suit.boards.size() &&
                       frame->health.boards.size() == suit.boards.size() &&
                       readiness.source_good_pairs.size() == suit.sources.size();
    if (!known)
        return;
    PairGridContent content = headings(readiness);
    for (size_t source = 0; source < suit.sources.size(); ++source)
        for (size_t board = 0; board < suit.boards.size(); ++board)
            content.cells.push_back(cellOf(readiness, static_cast<int>(source), static_cast<int>(board)));
    grid_->setContent(std::move(content));
    fitRows();
    tellCell();
}

/// Each row has its name beside it, which wants to be read.
void LivePairs::fitRows() {
    grid_->setMinimumHeight(Theme::get().px(kAroundRows + kLeastRow * grid_->rowCount()));
}

void LivePairs::tellCell() {
    const bool any = grid_->currentRow() >= 0;
    cell_->setText(any ? grid_->content().cell(grid_->currentRow(), grid_->currentColumn()).words
                       : tr("Choose a cell to read it here."));
}

}  // namespace noctule::ui
