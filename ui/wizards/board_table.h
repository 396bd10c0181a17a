// SPDX-License-Identifier: Apache-2.0
// Which boards have what of a calibration: a row per board, a box per step, and how askew it sits now. Arrow
// keys and clicks choose a board.
#pragma once

#include <QWidget>

#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

class BoardTable : public QWidget {
    Q_OBJECT
public:
    explicit BoardTable(QWidget* parent = nullptr);

    void setRun(const WizardRun* run);
    int chosen() const { return chosen_; }
    void choose(int board);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void boardChosen(int board);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// Left edges and widths, pixels.
    struct Columns {
        int left, steps, step, tilt, tilt_width;
    };
    Columns placeColumns() const;
    void paintHead(QPainter& painter, const Columns& at) const;
    void paintRow(QPainter& painter, const Columns& at, int board) const;
    void refresh();
    int rowHeight() const;
    int boards() const;
    int stepColumns() const;
    void paintBox(QPainter& painter, const QRect& cell, int board, int step) const;

    const WizardRun* run_ = nullptr;
    int chosen_ = -1;
    int known_boards_ = 0;
};

}  // namespace noctule::ui
