// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/columns_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <set>

#include "core/job/atomic_file.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

constexpr int kColumnsDialogWidth = 940, kUnitsWidth = 250, kUnitLabels = 110, kMeaningWidth = 170,
              kSensorNameWidth = 130, kColumnRowsHeight = 240, kFirstValuesWidth = 190;
constexpr double kNoRate_hz = 0, kMostTableRate_hz = 10000;

struct ColumnMeaning {
    TableQuantity quantity;
    size_t axis;
    QString words;
};

std::vector<ColumnMeaning> columnMeanings() {
    std::vector<ColumnMeaning> all = {{TableQuantity::kNothing, 0, ColumnsDialog::tr("nothing")},
                                      {TableQuantity::kTime, 0, ColumnsDialog::tr("time")}};
    const std::pair<TableQuantity, QString> quantities[] = {
        {TableQuantity::kGyro, ColumnsDialog::tr("angular rate %1")},
        {TableQuantity::kAccel, ColumnsDialog::tr("acceleration %1")},
        {TableQuantity::kMag, ColumnsDialog::tr("magnetic field %1")},
        {TableQuantity::kQuaternion, ColumnsDialog::tr("attitude %1")}};
    for (const auto& [quantity, words] : quantities)
        for (size_t axis = 0; axis < axisCount(quantity); ++axis)
            all.push_back(
                {quantity, axis,
                 words.arg(QChar((quantity == TableQuantity::kQuaternion ? "WXYZ" : "XYZ")[axis]))});
    return all;
}

QComboBox* unitBox(TableQuantity quantity, const std::string& chosen) {
    auto* box = new QComboBox;
    for (const TableUnit& unit : unitsOf(quantity))
        box->addItem(QString::fromUtf8(unit.name));
    box->setCurrentText(QString::fromStdString(chosen));
    keepMinimumHeight(*box, 30);
    return box;
}

/// "0.12, 0.13, 0.14"
QString firstCells(const TableColumn& column) {
    QStringList cells;
    for (const std::string& cell : column.cells)
        cells.append(QString::fromStdString(cell));
    return cells.join(", ");
}

}  // namespace

ColumnsDialog::ColumnsDialog(const QString& file, TableColumns table, QWidget* parent)
    : DialogFrame(tr("Columns of %1").arg(file),
                  tr("Say what each column is. It was guessed from names and first values; check the units."),
                  tr("Use these columns"), parent),
      time_unit(unitBox(TableQuantity::kTime, table.time_unit)),
      gyro_unit(unitBox(TableQuantity::kGyro, table.gyro_unit)),
      accel_unit(unitBox(TableQuantity::kAccel, table.accel_unit)),
      mag_unit(unitBox(TableQuantity::kMag, table.mag_unit)),
      rate(new QDoubleSpinBox),
      save_map(makeButton(ButtonKind::kText, tr("Save as a map…"))),
      table_(std::move(table)),
      counts_((new Label({}, TextRole::kSecondary, Ink::kHint))->wrapped()) {
    setWide(kColumnsDialogWidth);
    auto* halves = noctule::ui::addRow(content(), 20);
    halves->addWidget(makeRows(), 1);
    halves->addWidget(makeUnits());
    connect(rate, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ColumnsDialog::refresh);
    connect(save_map, &QPushButton::clicked, this, &ColumnsDialog::saveMap);
    refresh();
}

QWidget* ColumnsDialog::makeRows() {
    auto* rows = new QWidget;
    auto* grid = makeGrid(rows, {0, 0, 8, 0}, 6);
    int place = 0;
    for (const QString& head : {tr("Column"), tr("First values"), tr("Is"), tr("Sensor")})
        grid->addWidget(new Label(head, TextRole::kSecondary, Ink::kHint), 0, place++);
    for (size_t column = 0; column < table_.columns.size(); ++column)
        addRow(*grid, column);
    grid->setColumnStretch(0, 1);
    grid->setRowStretch(static_cast<int>(table_.columns.size()) + 1, 1);
    auto* area = new ScrollArea(rows);
    keepMinimumHeight(*area, kColumnRowsHeight);
    return area;
}

void ColumnsDialog::addRow(QGridLayout& grid, size_t column) {
    const TableColumn& one = table_.columns[column];
    const QString name = QString::fromStdString(one.name);
    Row row{new QComboBox, new QLineEdit(QString::fromStdString(one.sensor))};
    for (const ColumnMeaning& meaning : columnMeanings()) {
        row.meaning->addItem(meaning.words);
        if (meaning.quantity == one.quantity && meaning.axis == one.axis)
            row.meaning->setCurrentIndex(row.meaning->count() - 1);
    }
    row.meaning->setAccessibleName(tr("What column %1 is").arg(name));
    row.sensor->setAccessibleName(tr("Sensor of column %1").arg(name));
    row.sensor->setMaxLength(60);
    keepSize(*row.meaning, kMeaningWidth, 0);
    keepSize(*row.sensor, kSensorNameWidth, 0);
    auto* label = new ElidedLabel(name, TextRole::kBody, Ink::kValue);
    auto* cells = new ElidedLabel(firstCells(one), TextRole::kSecondary, Ink::kHint);
    keepMaximumWidth(*cells, kFirstValuesWidth);
    const int line = static_cast<int>(column) + 1;
    int place = 0;
    for (QWidget* widget : std::initializer_list<QWidget*>{label, cells, row.meaning, row.sensor})
        grid.addWidget(widget, line, place++);
    connect(row.meaning, qOverload<int>(&QComboBox::currentIndexChanged), this, &ColumnsDialog::refresh);
    connect(row.sensor, &QLineEdit::textChanged, this, &ColumnsDialog::refresh);
    rows_.push_back(row);
}

QWidget* ColumnsDialog::makeUnits() {
    auto* side = new QWidget;
    auto* column = makeColumn(side, {}, 8);
    column->addWidget(new Label(tr("Units"), TextRole::kSection, Ink::kValue, true));
    auto* form = new FormRows(kUnitLabels);
    form->addRow(tr("Time"), time_unit);
    form->addRow(tr("Angular rate"), gyro_unit);
    form->addRow(tr("Acceleration"), accel_unit);
    form->addRow(tr("Magnetic field"), mag_unit);
    rate->setRange(kNoRate_hz, kMostTableRate_hz);
    rate->setDecimals(3);
    rate->setSuffix(tr(" Hz"));
    rate->setSpecialValueText(tr("from the time"));
    keepMinimumHeight(*rate, 30);
    form->addRow(tr("Rate"), rate);
    column->addWidget(form);
    column->addWidget(counts_);
    column->addStretch(1);
    column->addWidget(save_map);
    keepSize(*side, kUnitsWidth, 0);
    return side;
}

void ColumnsDialog::readFields() {
    static const std::vector<ColumnMeaning> all = columnMeanings();
    for (size_t i = 0; i < rows_.size(); ++i) {
        const ColumnMeaning& meaning =
            all[static_cast<size_t>(std::max(0, rows_[i].meaning->currentIndex()))];
        TableColumn& column = table_.columns[i];
        column.quantity = meaning.quantity;
        column.axis = meaning.axis;
        const bool of_sensor =
            meaning.quantity != TableQuantity::kNothing && meaning.quantity != TableQuantity::kTime;
        column.sensor = of_sensor ? rows_[i].sensor->text().trimmed().toStdString() : std::string();
        rows_[i].sensor->setEnabled(of_sensor);
    }
    for (const auto& [box, unit] :
         {std::pair{time_unit, &table_.time_unit}, std::pair{gyro_unit, &table_.gyro_unit},
          std::pair{accel_unit, &table_.accel_unit}, std::pair{mag_unit, &table_.mag_unit}})
        *unit = box->currentText().toStdString();
}

void ColumnsDialog::refresh() {
    readFields();
    std::set<std::string> sensors;
    for (const TableColumn& column : table_.columns)
        if (!column.sensor.empty())
            sensors.insert(column.sensor);
    counts_->setText(tr("%n sensor(s) in these columns", nullptr, static_cast<int>(sensors.size())));
    const auto map = mapOfColumns(table_, rate->value());
    const QString problem = map ? QString() : coreWords(map.error().text());
    actionButton()->setDisabledBecause(problem);
    save_map->setDisabledBecause(problem);
    setProblem(problem);
}

void ColumnsDialog::accept() {
    readFields();
    const auto map = mapOfColumns(table_, rate->value());
    if (!map)
        return setProblem(coreWords(map.error().text()));
    map_ = *map;
    DialogFrame::accept();
}

void ColumnsDialog::saveMap() {
    readFields();
    const auto map = mapOfColumns(table_, rate->value());
    const QString path =
        map ? FileChoice{"import_maps", tr("Save the map"), tr("Import maps (*.json)"), "map.json"}.toSave(
                  this)
            : QString();
    if (path.isEmpty())
        return;
    // The file dialog has asked before it replaces a file.
    const Status written = writeFileAtomically(path.toStdString(), map->dump(1) + "\n", true);
    setProblem(written ? QString() : coreWords(written.error().text()));
}

}  // namespace noctule::ui
