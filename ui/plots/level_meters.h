// SPDX-License-Identifier: Apache-2.0
// A meter per board, in dB below full scale: sound as the wide bar with its peak held, motion as the thin
// one, the boards in the order of the suit with the parts of the body below. A board that clips is in the
// colour of warnings, one that is silent an empty dashed column. Click and arrow keys choose a board.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/plots/pair_grid.h"

namespace noctule::ui {

struct BoardLevel {
    QString name;  ///< "Right forearm (board 11)"
    double sound_db = 0, peak_db = 0;
    std::optional<double> motion_db;
    bool clips = false;
    bool silent = false;
};

class LevelMeters : public QWidget {
    Q_OBJECT
public:
    static constexpr double kLowest_db = -48;

    explicit LevelMeters(QWidget* parent = nullptr);

    void setGroups(std::vector<PairColumnGroup> groups);
    void setLevels(std::vector<BoardLevel> levels);
    const std::vector<BoardLevel>& levels() const { return levels_; }
    /// -1: none. Says nothing.
    void setCurrent(int board);
    int current() const { return current_; }
    /// "Right forearm (board 11): sound -12 dB, peak -0.4 dB, motion -20 dB"
    QString words(int board) const;
    /// -1 beside the meters.
    int boardAt(const QPoint& position) const;
    QRect meterRect(int board) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void chosen(int board);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    int count() const { return static_cast<int>(levels_.size()); }
    QRectF area() const;
    double y(double db) const;
    void choose(int board);
    void paintScale(QPainter& painter) const;
    void paintBoard(QPainter& painter, int board) const;
    void paintNumbers(QPainter& painter) const;
    void paintGroups(QPainter& painter) const;
    QString summary() const;

    std::vector<PairColumnGroup> groups_;
    std::vector<BoardLevel> levels_;
    int current_ = -1;
};

}  // namespace noctule::ui
