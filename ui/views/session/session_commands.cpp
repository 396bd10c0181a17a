// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/session_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "core/session/session.h"
#include "ui/models/shared_context.h"
#include "ui/views/session/new_session_dialog.h"
#include "ui/views/session/transfer_dialog.h"

namespace noctule::ui {
namespace {

QString lastFolder(SharedContext& shared, const char* key) {
    return shared.settings().value(key, shared.sessionsFolder()).toString();
}

}  // namespace

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
    const QString folder = QFileDialog::getExistingDirectory(parent, tr("Open session"),
                                                             lastFolder(shared, "folders/last_session"));
    if (folder.isEmpty())
        return;
    shared.settings().setValue("folders/last_session", QFileInfo(folder).dir().path());
    shared.session().open(folder);
}

QStringList SessionCommands::askForTakes(QWidget* parent, SharedContext& shared) {
    const QStringList paths = QFileDialog::getOpenFileNames(
        parent, tr("Choose takes"), lastFolder(shared, "folders/last_take"), tr("Takes (*.noctule)"));
    if (!paths.isEmpty())
        shared.settings().setValue("folders/last_take", QFileInfo(paths.first()).dir().path());
    return paths;
}

QString SessionCommands::askForMotion(QWidget* parent, SharedContext& shared) {
    const QString path = QFileDialog::getOpenFileName(parent, tr("Choose a motion"),
                                                      shared.settings().value("folders/motions").toString(),
                                                      tr("Motions (*.bvh *.fbx *.glb *.gltf *.vrm *.dae)"));
    if (!path.isEmpty())
        shared.settings().setValue("folders/motions", QFileInfo(path).path());
    return path;
}

QStringList SessionCommands::askForRecording(QWidget* parent, SharedContext& shared) {
    const QStringList paths = QFileDialog::getOpenFileNames(
        parent, tr("Choose the files of one recording"),
        shared.settings().value("folders/recordings").toString(),
        tr("Recordings of sensors (*.mat *.mvnx *.txt *.ximu3 *.sto *.csv *.tsv)"));
    if (!paths.isEmpty())
        shared.settings().setValue("folders/recordings", QFileInfo(paths.first()).path());
    return paths;
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
