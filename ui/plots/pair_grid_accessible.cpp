// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/pair_grid_accessible.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QPointer>

#include "ui/plots/pair_grid.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

class CellInterface : public QAccessibleInterface, public QAccessibleTableCellInterface {
public:
    CellInterface(PairGrid* grid, int row, int column) : grid_(grid), row_(row), column_(column) {}

    bool isValid() const override {
        return grid_ && row_ < grid_->rowCount() && column_ < grid_->columnCount();
    }
    QObject* object() const override { return nullptr; }
    QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(grid_); }
    QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    QAccessibleInterface* child(int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    QAccessible::Role role() const override { return QAccessible::Cell; }
    void setText(QAccessible::Text, const QString&) override {}
    QRect rect() const override {
        if (!isValid())
            return {};
        const QRect cell = grid_->cellRect(row_, column_);
        return {grid_->mapToGlobal(cell.topLeft()), cell.size()};
    }
    QString text(QAccessible::Text which) const override {
        if (!isValid())
            return {};
        const PairCell& cell = grid_->content().cell(row_, column_);
        switch (which) {
            case QAccessible::Name:
                return cell.words;
            case QAccessible::Value:
                return cell.state == PairCell::State::kHeard ? numberText(cell.confidence, 2) : QString();
            default:
                return {};
        }
    }
    QAccessible::State state() const override {
        QAccessible::State state;
        state.selectable = true;
        state.focusable = true;
        state.selected = isSelected();
        state.focused = isSelected() && grid_->hasFocus();
        return state;
    }
    void* interface_cast(QAccessible::InterfaceType type) override {
        return type == QAccessible::TableCellInterface ? static_cast<QAccessibleTableCellInterface*>(this)
                                                       : nullptr;
    }

    int columnExtent() const override { return 1; }
    int rowExtent() const override { return 1; }
    int columnIndex() const override { return column_; }
    int rowIndex() const override { return row_; }
    QList<QAccessibleInterface*> columnHeaderCells() const override { return {}; }
    QList<QAccessibleInterface*> rowHeaderCells() const override { return {}; }
    bool isSelected() const override {
        return isValid() && grid_->currentRow() == row_ && grid_->currentColumn() == column_;
    }
    QAccessibleInterface* table() const override { return parent(); }

private:
    QPointer<PairGrid> grid_;
    int row_, column_;
};

class GridInterface : public QAccessibleWidget, public QAccessibleTableInterface {
public:
    explicit GridInterface(PairGrid* grid) : QAccessibleWidget(grid, QAccessible::Table), grid_(grid) {}
    ~GridInterface() override { forgetCells(); }

    void forgetCells() const {
        for (const QAccessible::Id id : cells_)
            QAccessible::deleteAccessibleInterface(id);
        cells_.clear();
    }

    int childCount() const override { return rowCount() * columnCount(); }
    QAccessibleInterface* child(int index) const override {
        if (index < 0 || index >= childCount())
            return nullptr;
        if (static_cast<int>(cells_.size()) != childCount())
            makeCells();
        return QAccessible::accessibleInterface(cells_[static_cast<size_t>(index)]);
    }
    void makeCells() const {
        forgetCells();
        for (int i = 0; i < childCount(); ++i)
            cells_.push_back(QAccessible::registerAccessibleInterface(
                new CellInterface(grid_, i / columnCount(), i % columnCount())));
    }
    QAccessibleInterface* childAt(int x, int y) const override {
        const QPoint cell = grid_->cellAt(grid_->mapFromGlobal(QPoint(x, y)));
        return cell.x() < 0 ? nullptr : cellAt(cell.y(), cell.x());
    }
    int indexOfChild(const QAccessibleInterface* child) const override {
        for (int i = 0; i < static_cast<int>(cells_.size()); ++i)
            if (this->child(i) == child)
                return i;
        return -1;
    }
    QAccessibleInterface* focusChild() const override {
        return grid_->hasFocus() ? cellAt(grid_->currentRow(), grid_->currentColumn()) : nullptr;
    }
    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::TableInterface)
            return static_cast<QAccessibleTableInterface*>(this);
        return QAccessibleWidget::interface_cast(type);
    }

    QAccessibleInterface* caption() const override { return nullptr; }
    QAccessibleInterface* summary() const override { return nullptr; }
    QAccessibleInterface* cellAt(int row, int column) const override {
        return row < 0 || column < 0 ? nullptr : child(row * columnCount() + column);
    }
    int selectedCellCount() const override { return grid_->currentRow() >= 0 ? 1 : 0; }
    QList<QAccessibleInterface*> selectedCells() const override {
        if (grid_->currentRow() < 0)
            return {};
        return {cellAt(grid_->currentRow(), grid_->currentColumn())};
    }
    QString columnDescription(int column) const override {
        return grid_->content().columns.at(static_cast<size_t>(column)).tooltip;
    }
    QString rowDescription(int row) const override {
        return grid_->content().rows.at(static_cast<size_t>(row)).tooltip;
    }
    int selectedColumnCount() const override { return 0; }
    int selectedRowCount() const override { return 0; }
    int columnCount() const override { return grid_->columnCount(); }
    int rowCount() const override { return grid_->rowCount(); }
    QList<int> selectedColumns() const override { return {}; }
    QList<int> selectedRows() const override { return {}; }
    bool isColumnSelected(int) const override { return false; }
    bool isRowSelected(int) const override { return false; }
    bool selectRow(int) override { return false; }
    bool selectColumn(int) override { return false; }
    bool unselectRow(int) override { return false; }
    bool unselectColumn(int) override { return false; }
    void modelChange(QAccessibleTableModelChangeEvent*) override { forgetCells(); }

private:
    PairGrid* grid_;
    mutable std::vector<QAccessible::Id> cells_;
};

QAccessibleInterface* makeGridInterface(const QString&, QObject* object) {
    auto* grid = qobject_cast<PairGrid*>(object);
    return grid ? new GridInterface(grid) : nullptr;
}

}  // namespace

void PairGridAccessible::install() {
    static const bool installed = [] {
        QAccessible::installFactory(makeGridInterface);
        return true;
    }();
    static_cast<void>(installed);
}

void PairGridAccessible::contentChanged(PairGrid& grid) {
    QAccessibleTableModelChangeEvent event(&grid, QAccessibleTableModelChangeEvent::ModelReset);
    QAccessible::updateAccessibility(&event);
}

void PairGridAccessible::currentChanged(PairGrid& grid) {
    if (grid.currentRow() < 0 || !grid.hasFocus())
        return;
    QAccessibleEvent event(&grid, QAccessible::Focus);
    event.setChild(grid.currentRow() * grid.columnCount() + grid.currentColumn());
    QAccessible::updateAccessibility(&event);
}

}  // namespace noctule::ui
