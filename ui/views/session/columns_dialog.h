// SPDX-License-Identifier: Apache-2.0
// What the columns of a table of another program are: a guess from names and first values, which the operator
// corrects. It becomes the map by which the table is read.
#pragma once

#include "core/import/table_columns.h"
#include "ui/views/dialog_frame.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLineEdit;

namespace noctule::ui {

class Button;
class FormRows;
class Label;

class ColumnsDialog : public DialogFrame {
    Q_OBJECT
public:
    ColumnsDialog(const QString& file, TableColumns table, QWidget* parent = nullptr);

    /// After it was accepted.
    const nlohmann::json& map() const { return map_; }
    /// As the operator left it.
    const TableColumns& table() const { return table_; }
    /// Of the column at this place.
    QComboBox* meaningOf(size_t column) const { return rows_[column].meaning; }
    QLineEdit* sensorOf(size_t column) const { return rows_[column].sensor; }

    // For the operator and tests.
    QComboBox *time_unit, *gyro_unit, *accel_unit, *mag_unit;
    QDoubleSpinBox* rate;
    Button* save_map;

public slots:
    void accept() override;

private:
    struct Row {
        QComboBox* meaning;
        QLineEdit* sensor;
    };
    QWidget* makeRows();
    void addRow(QGridLayout& grid, size_t column);
    QWidget* makeUnits();
    void readFields();
    void refresh();
    void saveMap();

    TableColumns table_;
    std::vector<Row> rows_;
    Label* counts_;
    nlohmann::json map_;
};

}  // namespace noctule::ui
