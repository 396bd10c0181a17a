// SPDX-License-Identifier: Apache-2.0
// "Confidence per pair" of the take under review: sources by boards, coloured by mean confidence between in
// and out, or over the last three rounds at the cursor. Choosing a cell chooses the pair everywhere; below
// the cells stands the pair in words.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"
#include "ui/plots/pair_grid.h"
#include "ui/plots/repaint_limit.h"

namespace noctule::ui {

class ElidedLabel;
class Label;
class ToolButton;

class HeatMap : public QWidget {
    Q_OBJECT
public:
    explicit HeatMap(ReviewContext& review, QWidget* parent = nullptr);

    PairGrid& grid() { return *grid_; }
    /// Off: mean between in and out.
    bool showsCursor() const { return at_cursor_; }
    void setShowsCursor(bool at_cursor);
    /// The chosen pair in words, two lines.
    QString readout() const;

private:
    void build();
    void connectStudio();
    void readTake();
    void refreshCells();
    void tellPair();
    std::pair<double, double> interval() const;
    PairCell cellOf(int source, int board) const;
    QString wordsOf(int source, int board, const PairCell& cell) const;

    ReviewContext& review_;
    Label *title_ = nullptr, *hint_ = nullptr;
    ToolButton* cursor_switch_ = nullptr;
    PairGrid* grid_ = nullptr;
    ElidedLabel *pair_text_ = nullptr, *detail_text_ = nullptr;
    std::shared_ptr<const TakeOverview> overview_;
    std::shared_ptr<const PairSummaries> summaries_;
    RepaintLimit repaint_;
    bool at_cursor_ = false;
};

}  // namespace noctule::ui
