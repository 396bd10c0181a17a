// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/session_commands.h"

#include <QDialog>
#include <QDir>
#include <QFileInfo>

#include "core/session/session.h"
#include "ui/models/file_choice.h"
#include "ui/models/shared_context.h"
#include "ui/views/session/new_session_dialog.h"
#include "ui/views/session/transfer_dialog.h"

namespace noctule::ui {

void SessionCommands::askForTransfer(QWidget* parent, SharedContext& shared, int take,
                                     SessionModel::Transfer how) {
    SessionModel& session = shared.session();
    const std::string name = session.session().takes[static_cast<size_t>(take)].name;
    TransferDialog dialog(shared, QString::fromStdString(name), how, parent);
    if (dialog.exec() == QDialog::Accepted && session.isOpen())
        session.transferTake(session.session().findTake(name), dialog.folder(), how);
}

bool SessionCommands::isSession(const QString& folder) {
    return QFileInfo(QDir(folder).filePath("session.json")).isFile();
}

bool SessionCommands::canBeOpened(const QString& folder) {
    return isSession(folder) || canRebuildSession(folder.toStdString());
}

QString SessionCommands::sessionOfTake(const QString& take_path) {
    QDir folder = QFileInfo(take_path).dir();
    if (folder.dirName() != "takes" || !folder.cdUp() || !isSession(folder.path()))
        return {};
    return folder.path();
}

void SessionCommands::askForNew(QWidget* parent, SharedContext& shared) {
    NewSessionDialog(shared, parent).exec();
}

void SessionCommands::askToOpen(QWidget* parent, SharedContext& shared) {
    const QString folder =
        FileChoice{.kind = "last_session", .title = tr("Open session"), .usual = shared.sessionsFolder()}
            .folder(parent);
    if (!folder.isEmpty())
        shared.session().open(folder);
}

QStringList SessionCommands::askForTakes(QWidget* parent, SharedContext& shared) {
    return FileChoice{.kind = "last_take",
                      .title = tr("Choose takes"),
                      .filter = tr("Takes (*.noctule)"),
                      .usual = shared.sessionsFolder()}
        .severalToOpen(parent);
}

QString SessionCommands::askForMotion(QWidget* parent) {
    return FileChoice{"motions", tr("Choose a motion"), tr("Motions (*.bvh *.fbx *.glb *.gltf *.vrm *.dae)")}
        .toOpen(parent);
}

QStringList SessionCommands::askForRecording(QWidget* parent) {
    return FileChoice{"recordings", tr("Choose the files of one recording"),
                      tr("Recordings of sensors (*.mat *.mvnx *.txt *.ximu3 *.sto *.csv *.tsv)")}
        .severalToOpen(parent);
}

void SessionCommands::import(QWidget* parent, SharedContext& shared, const QStringList& paths) {
    if (!paths.isEmpty() && !shared.session().isOpen())
        askForNew(parent, shared);
    if (!paths.isEmpty() && shared.session().isOpen())
        shared.session().importTakes(paths);
}

void SessionCommands::askForImport(QWidget* parent, SharedContext& shared) {
    import(parent, shared, askForTakes(parent, shared));
}

}  // namespace noctule::ui
