// SPDX-License-Identifier: Apache-2.0
// "Pairs": the confidence of every source and board now, as a heat map; choosing a cell chooses its board.
#pragma once

#include <QWidget>

#include "ui/models/capture_context.h"
#include "ui/plots/pair_grid.h"

namespace noctule::ui {

class ElidedLabel;
class Label;

class LivePairs : public QWidget {
    Q_OBJECT
public:
    explicit LivePairs(CaptureContext& capture, QWidget* parent = nullptr);

    PairGrid& grid() { return *grid_; }
    void setBoard(int board);

signals:
    void boardChosen(int board);

private:
    void show(const Readiness& readiness);
    PairGridContent headings(const Readiness& readiness) const;
    PairCell cellOf(const Readiness& readiness, int source, int board) const;
    void fitRows();
    void tellCell();

    const SuitCheck& check() const { return capture_.check(); }

    CaptureContext& capture_;
    PairGrid* grid_;
    ElidedLabel* cell_;
};

}  // namespace noctule::ui
