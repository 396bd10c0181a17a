// SPDX-License-Identifier: Apache-2.0
// A recording of other sensors before it becomes a take: what was found in its files, on which segment each
// sensor sits, and what the operator corrects. Nothing is written before Import.
#pragma once

#include <QPointer>

#include "core/import/table_columns.h"
#include "ui/models/recording_import.h"
#include "ui/models/shared_context.h"
#include "ui/views/dialog_frame.h"

class QComboBox;
class QDoubleSpinBox;

namespace noctule::ui {

class Button;
class FormRows;
class JobProgress;
class Label;

class RecordingDialog : public DialogFrame {
    Q_OBJECT
public:
    RecordingDialog(SharedContext& shared, const QStringList& paths, QWidget* parent = nullptr);

    /// As it was understood; null while it is read or when it cannot be read.
    std::shared_ptr<const ImportedRecording> recording() const { return recording_; }
    bool isBusy() const;
    /// Of the sensor at this place; null while nothing is read.
    QComboBox* segmentOf(size_t sensor) const;
    /// A map of segments or of a table's columns, from a file; false and a problem shown when it is none.
    bool useMap(const QString& path);
    /// The columns of a table; null of other files, and while nobody has looked.
    const TableColumns* columns() const { return columns_ ? &*columns_ : nullptr; }
    /// What they are; remembered for tables with the same header.
    void useColumns(TableColumns columns, const nlohmann::json& map);

    // For the operator and tests.
    QComboBox* world;
    QDoubleSpinBox* rate;
    Button *by_movement, *choose_map, *say_columns;

public slots:
    void accept() override;

private:
    void makeFields();
    void read();
    void present(Result<ImportedRecording> read);
    void showFound();
    void showNotes();
    void makeSensorRows();
    void addSensorRow(size_t sensor, QWidget* rows);
    void putOnSegment(size_t sensor, const std::string& segment);
    void find();
    void askForMap();
    bool isTable() const;
    void lookAtColumns();
    void presentColumns(Result<TableColumns> columns);
    void askForColumns();
    QString columnsKey() const;
    void refresh();
    void keep();

    SharedContext& shared_;
    RecordingToRead request_;
    std::shared_ptr<ImportedRecording> recording_;
    std::optional<TableColumns> columns_;
    bool columns_remembered_ = false;  ///< what they are was said for a table like it
    std::optional<Error> problem_;
    std::vector<QComboBox*> segments_;
    QWidget* rows_ = nullptr;
    QBoxLayout* rows_column_ = nullptr;
    Label *format_, *sensors_, *gaps_, *reference_, *notes_, *warnings_, *open_;
    QStringList found_;  ///< what was said when segments were found by movement
    JobProgress* progress_;
    QPointer<Job> job_;
    bool fills_ = false;       ///< the fields are being filled, nobody corrects
    bool asks_again_ = false;  ///< a correction came while the files were read
};

}  // namespace noctule::ui
