// SPDX-License-Identifier: Apache-2.0
// The cells of a heat map, sources by boards, and nothing else: it is told values and words and says which
// cell was chosen. Review shows a take in it, Connect the suit as it is now. To a screen reader it is a
// table.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

namespace noctule::ui {

struct PairCell {
    enum class State {
        kHeard,
        kSilent,  ///< never heard: an empty dashed cell
        kLost,    ///< the board is gone: dashed in the colour of errors
    };
    State state = State::kSilent;
    double confidence = 0;  ///< 0..1
    QString words;          ///< "Source 5 to board 14, left shin: 0.41"; tooltip and accessible value
};

/// Words at the edges; `attention`: in the colour of warnings.
struct PairHeading {
    QString text, tooltip;
    bool attention = false;
};

struct PairColumnGroup {
    QString name;  ///< "L arm"
    int first = 0, last = 0;
};

struct PairGridContent {
    std::vector<PairHeading> rows, columns;
    std::vector<QString> row_notes;  ///< right of the rows: "10 good"; may be empty
    std::vector<PairColumnGroup> groups;
    std::vector<PairCell> cells;  ///< row * columns.size() + column

    const PairCell& cell(int row, int column) const {
        return cells[static_cast<size_t>(row) * columns.size() + static_cast<size_t>(column)];
    }
};

class PairGrid : public QWidget {
    Q_OBJECT
public:
    explicit PairGrid(QWidget* parent = nullptr);

    void setContent(PairGridContent content);
    const PairGridContent& content() const { return content_; }
    int rowCount() const { return static_cast<int>(content_.rows.size()); }
    int columnCount() const { return static_cast<int>(content_.columns.size()); }

    int currentRow() const { return row_; }
    int currentColumn() const { return column_; }
    /// -1: none. Says nothing.
    void setCurrent(int row, int column);

    QRect cellRect(int row, int column) const;
    /// (-1, -1) beside the cells; x is the column.
    QPoint cellAt(const QPoint& position) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The operator chose a cell.
    void chosen(int row, int column);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Where the cells and the words around them lie.
    struct Frame {
        QRectF cells;
        double cell_width = 0, cell_height = 0;  ///< with the gap
        int headings_height = 0, gap = 0;
        QRect cell(int row, int column) const;
    };
    Frame frame() const;
    int edgeWidth(bool notes) const;
    void choose(int row, int column);
    void paintCells(QPainter& painter, const Frame& frame) const;
    void paintCurrent(QPainter& painter, const Frame& frame) const;
    void paintHeadings(QPainter& painter, const Frame& frame) const;
    void paintGroups(QPainter& painter, const Frame& frame) const;

    PairGridContent content_;
    int row_ = -1, column_ = -1;
};

}  // namespace noctule::ui
