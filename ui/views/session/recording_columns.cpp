// SPDX-License-Identifier: Apache-2.0
// Which columns of a table are what, and which sensor sits where, as the operator says it to a
// RecordingDialog.
#include <QCryptographicHash>
#include <QDialog>
#include <QFileInfo>

#include "core/job/atomic_file.h"
#include "core/math/json.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/views/session/columns_dialog.h"
#include "ui/views/session/recording_dialog.h"
#include "ui/widgets/button.h"

namespace noctule::ui {

bool RecordingDialog::useMap(const QString& path) {
    const auto bytes = readWholeFile(path.toStdString(), {});
    const nlohmann::json map = bytes ? json::parse(*bytes) : nlohmann::json();
    if (!map.is_object() || map.value("format", nlohmann::json()) != "noctule-import-map") {
        setProblem(bytes ? tr("%1 is no import map.").arg(QFileInfo(path).fileName())
                         : coreWords(bytes.error()));
        return false;
    }
    request_.map = map;
    recording_.reset();
    read();
    return true;
}

void RecordingDialog::askForMap() {
    const QString path = FileChoice{.kind = "import_maps",
                                    .title = tr("Choose a map of sensors or columns"),
                                    .filter = tr("Import maps (*.json)"),
                                    .usual = QFileInfo(request_.paths.value(0)).path()}
                             .toOpen(this);
    if (!path.isEmpty())
        useMap(path);
}

/// Of any program, and of none whose tables are known.
bool RecordingDialog::isTable() const {
    static const QStringList kTables{"csv", "txt", "tsv"};
    const bool named =
        request_.paths.size() == 1 && kTables.contains(QFileInfo(request_.paths[0]).suffix().toLower());
    return named &&
           (recording_ ? recording_->format == "csv" : problem_ && problem_->kind == ErrorKind::kUsage);
}

void RecordingDialog::lookAtColumns() {
    shared_.jobs().start<TableColumns>(
        tr("Looking at the columns"),
        [path = request_.paths[0].toStdString()](const JobContext&) { return guessColumns(path); },
        [self = QPointer(this)](Result<TableColumns> columns) -> QString {
            if (self)
                self->presentColumns(std::move(columns));
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void RecordingDialog::presentColumns(Result<TableColumns> columns) {
    if (columns)
        columns_ = std::move(*columns);
    else
        problem_ = columns.error();
    const QString key = columns_ ? columnsKey() : QString();
    const nlohmann::json map = key.isEmpty()
                                   ? nlohmann::json()
                                   : json::parse(shared_.settings().value(key).toString().toStdString());
    if (map.is_object() && request_.map.is_null()) {
        useColumns(*columns_, map);
        columns_remembered_ = true;
    }
    refresh();
}

/// Empty without a header: such tables cannot be told from each other. By the header: tables of one program
/// are read alike.
QString RecordingDialog::columnsKey() const {
    if (!columns_->has_header)
        return {};
    QByteArray names;
    for (const TableColumn& column : columns_->columns)
        names += QByteArray::fromStdString(column.name) + '\n';
    return "import_columns/" +
           QString::fromLatin1(QCryptographicHash::hash(names, QCryptographicHash::Sha1).toHex());
}

void RecordingDialog::askForColumns() {
    if (!columns_)
        return;
    ColumnsDialog dialog(QFileInfo(request_.paths[0]).fileName(), *columns_, this);
    if (dialog.exec() == QDialog::Accepted)
        useColumns(dialog.table(), dialog.map());
}

void RecordingDialog::useColumns(TableColumns columns, const nlohmann::json& map) {
    columns_ = std::move(columns);
    request_.map = map;
    columns_remembered_ = false;
    if (const QString key = columnsKey(); !key.isEmpty())
        shared_.settings().setValue(key, QString::fromStdString(map.dump()));
    recording_.reset();
    read();
}

}  // namespace noctule::ui
