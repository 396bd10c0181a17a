// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heat_map.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

#include "core/review/plot_series.h"
#include "ui/models/part_names.h"
#include "ui/plots/confidence_legend.h"
#include "ui/plots/heard_switch.h"
#include "ui/plots/pair_columns.h"
#include "ui/style/words.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
HeatMap::HeatMap(ReviewContext& review, QWidget* parent)
    : QWidget(parent), review_(review), repaint_([this] { refreshCells(); }) {
    build();
    connectStudio();
    readTake();
}

void HeatMap::build() {
    title_ = new Label(tr("Confidence per pair"), TextRole::kBody, Ink::kValue, true);
    hint_ = new Label({}, TextRole::kCaption, Ink::kHint);
    cursor_switch_ = new ToolButton(QStringLiteral("clock"), tr("Confidence at the cursor"));
    cursor_switch_->setCheckable(true);
    grid_ = new PairGrid;
    pair_text_ = new ElidedLabel({}, TextRole::kSecondary, Ink::kValue);
    detail_text_ = new ElidedLabel({}, TextRole::kCaption, Ink::kHint);

    auto* head = new QHBoxLayout;
    head->addWidget(title_);
    head->addStretch(1);
    head->addWidget(hint_);
    head->addWidget(cursor_switch_);
    auto* words = new QVBoxLayout;
    words->addWidget(pair_text_);
    words->addWidget(detail_text_);
    auto* foot = new QHBoxLayout;
    foot->addLayout(words, 1);
    foot->addWidget(new ConfidenceLegend, 0, Qt::AlignTop);

    auto* column = new QVBoxLayout(this);
    const auto place = [column, words] {
        const Theme& theme = Theme::get();
        column->setContentsMargins(theme.px(16), theme.px(4), theme.px(16), theme.px(8));
        column->setSpacing(theme.px(4));
        words->setSpacing(theme.px(2));
    };
    place();
    connect(&Theme::get(), &Theme::changed, this, place);
    column->addLayout(head);
    column->addWidget(new HeardSwitch(review_));
    column->addWidget(grid_, 1);
    column->addLayout(foot);
}

void HeatMap::connectStudio() {
    TakeDocument& take = review_.take();
    connect(&take, &TakeDocument::opened, this, &HeatMap::readTake);
    connect(&take, &TakeDocument::runsChanged, this, &HeatMap::readTake);
    connect(&take, &TakeDocument::processingChanged, this, &HeatMap::tellPair);
    connect(&take, &TakeDocument::rangesChanged, this, &HeatMap::readTake);
    connect(&review_.time(), &TimeCursor::rangeChanged, this, [this] { repaint_.ask(); });
    connect(&review_.time(), &TimeCursor::timeChanged, this, [this] {
        if (at_cursor_)
            repaint_.ask();
    });
    Selection& selection = review_.selection();
    connect(&selection, &Selection::pairChanged, this, &HeatMap::tellPair);
    connect(grid_, &PairGrid::chosen, &selection, &Selection::setPair);
    connect(cursor_switch_, &QAbstractButton::toggled, this, &HeatMap::setShowsCursor);
}

void HeatMap::setShowsCursor(bool at_cursor) {
    at_cursor_ = at_cursor;
    cursor_switch_->setChecked(at_cursor);
    refreshCells();
}

QString HeatMap::readout() const {
    return pair_text_->text() + QLatin1Char('\n') + detail_text_->text();
}

void HeatMap::readTake() {
    overview_ = review_.take().overview();
    summaries_ = overview_ ? review_.take().pairSummaries() : nullptr;
    refreshCells();
}

std::pair<double, double> HeatMap::interval() const {
    const TimeCursor& time = review_.time();
    if (at_cursor_)
        return {time.time() - kPairHold_s, std::nextafter(time.time(), time.time() + 1)};
    return {time.in(), time.out()};
}

PairCell HeatMap::cellOf(int source, int board) const {
    PairCell cell;
    const auto [from_s, to_s] = interval();
    const PairWindow window = summaries_->window(source, board, from_s, to_s);
    if (window.heard > 0) {
        cell.state = PairCell::State::kHeard;
        cell.confidence = window.mean_confidence;
    }
    return cell;
}

QString HeatMap::wordsOf(int source, int board, const PairCell& cell) const {
    const QString place = boardName(overview_->suit.boards[static_cast<size_t>(board)], NameCase::kInside);
    switch (cell.state) {
        case PairCell::State::kHeard:
            return tr("Source %1 to board %2, %3: %4")
                .arg(source + 1)
                .arg(board + 1)
                .arg(place, numberText(cell.confidence, 2));
        case PairCell::State::kLost:
            // Without offsets no range was made of what the board heard.
            return overview_->lack.ofAllOffsets()
                       ? tr("Board %1, %2: heard, but not usable without source offsets")
                             .arg(board + 1)
                             .arg(place)
                       : tr("Board %1, %2, hears no source").arg(board + 1).arg(place);
        case PairCell::State::kSilent:
            break;
    }
    if (overview_->lack.ofAllOffsets())
        return tr("Source %1 to board %2, %3: heard, but not usable without source offsets")
            .arg(source + 1)
            .arg(board + 1)
            .arg(place);
    return tr("Source %1 to board %2, %3: not heard").arg(source + 1).arg(board + 1).arg(place);
}

void HeatMap::refreshCells() {
    hint_->setText(at_cursor_ ? tr("now, at the cursor") : tr("mean between in and out"));
    PairGridContent content;
    if (overview_ && summaries_) {
        const Suit& suit = *review_.take().pairSuit();
        const int sources = std::min(static_cast<int>(suit.sources.size()), summaries_->sourceCount());
        const int boards = std::min(static_cast<int>(suit.boards.size()), summaries_->boardCount());
        for (int s = 0; s < sources; ++s)
            content.rows.push_back({tr("S%1", "source number").arg(s + 1), sourceTitle(suit, s)});
        for (int b = 0; b < boards; ++b)
            content.columns.push_back({QString::number(b + 1), boardTitle(suit, b)});
        content.groups = columnGroups(suit);
        content.cells.resize(static_cast<size_t>(sources * boards));
        for (int b = 0; b < boards; ++b) {
            bool hears = false;
            const auto at = [&](int s) -> PairCell& {
                return content.cells[static_cast<size_t>(s * boards + b)];
            };
            for (int s = 0; s < sources; ++s) {
                at(s) = cellOf(s, b);
                hears = hears || at(s).state == PairCell::State::kHeard;
            }
            for (int s = 0; s < sources; ++s) {
                if (!hears && !at_cursor_)
                    at(s).state = PairCell::State::kLost;
                at(s).words = wordsOf(s, b, at(s));
            }
        }
    }
    grid_->setContent(std::move(content));
    tellPair();
}

void HeatMap::tellPair() {
    const int source = review_.selection().source(), board = review_.selection().board();
    grid_->setCurrent(source, board);
    if (!overview_) {
        pair_text_->setText(tr("Open a take to see how well each board heard each source"));
        detail_text_->clear();
        return;
    }
    if (review_.take().shownRun() < 0) {
        pair_text_->setText(
            review_.take().processing()
                ? tr("This take is being processed.")
                : tr("This take has no result yet. Process it to see which board heard which source."));
        detail_text_->clear();
        return;
    }
    if (!summaries_) {
        const bool failed = !review_.take().problem().isEmpty() && !review_.take().isLoading();
        pair_text_->setText(failed ? review_.take().problem() : tr("Reading ranges"));
        detail_text_->clear();
        return;
    }
    if (grid_->currentRow() < 0) {
        pair_text_->setText(tr("Choose a pair to see its curve and its ray"));
        detail_text_->clear();
        return;
    }
    const PairCell& cell = grid_->content().cell(source, board);
    pair_text_->setText(cell.words);
    const auto [from_s, to_s] = interval();
    const PairWindow window = summaries_->window(source, board, from_s, to_s);
    if (cell.state != PairCell::State::kHeard) {
        detail_text_->clear();
        return;
    }
    if (window.used == 0 && window.gated == 0) {
        detail_text_->setText(tr("%1 ranges heard, none used by this result").arg(countText(window.heard)));
        return;
    }
    const QString kept =
        tr("%1 ranges kept, %2 left out").arg(countText(window.used), countText(window.gated));
    detail_text_->setText(window.residual_rms_m
                              ? tr("%1, residual %2").arg(kept, millimetresText(*window.residual_rms_m))
                              : kept);
}

}  // namespace noctule::ui
