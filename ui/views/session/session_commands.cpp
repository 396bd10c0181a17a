// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/session_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "core/session/session.h"
#include "ui/models/studio.h"
#include "ui/views/session/new_session_dialog.h"

namespace noctule::ui {
namespace {

QString lastFolder(Studio& studio, const char* key) {
    return studio.settings().value(key, studio.sessionsFolder()).toString();
}

}  // namespace

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

void SessionCommands::askForNew(QWidget* parent, Studio& studio) {
    NewSessionDialog(studio, parent).exec();
}

void SessionCommands::askToOpen(QWidget* parent, Studio& studio) {
    const QString folder = QFileDialog::getExistingDirectory(parent, tr("Open session"),
                                                             lastFolder(studio, "folders/last_session"));
    if (folder.isEmpty())
        return;
    studio.settings().setValue("folders/last_session", QFileInfo(folder).dir().path());
    studio.session().open(folder);
}

QStringList SessionCommands::askForTakes(QWidget* parent, Studio& studio) {
    const QStringList paths = QFileDialog::getOpenFileNames(
        parent, tr("Choose takes"), lastFolder(studio, "folders/last_take"), tr("Takes (*.noctule)"));
    if (!paths.isEmpty())
        studio.settings().setValue("folders/last_take", QFileInfo(paths.first()).dir().path());
    return paths;
}

QString SessionCommands::askForMotion(QWidget* parent, Studio& studio) {
    const QString path = QFileDialog::getOpenFileName(parent, tr("Choose a motion"),
                                                      studio.settings().value("folders/motions").toString(),
                                                      tr("Motions (*.bvh *.fbx *.glb *.gltf *.vrm *.dae)"));
    if (!path.isEmpty())
        studio.settings().setValue("folders/motions", QFileInfo(path).path());
    return path;
}

QStringList SessionCommands::askForRecording(QWidget* parent, Studio& studio) {
    const QStringList paths = QFileDialog::getOpenFileNames(
        parent, tr("Choose the files of one recording"),
        studio.settings().value("folders/recordings").toString(),
        tr("Recordings of sensors (*.mat *.mvnx *.txt *.ximu3 *.sto *.csv *.tsv)"));
    if (!paths.isEmpty())
        studio.settings().setValue("folders/recordings", QFileInfo(paths.first()).path());
    return paths;
}

void SessionCommands::import(QWidget* parent, Studio& studio, const QStringList& paths) {
    if (!paths.isEmpty() && !studio.session().isOpen())
        askForNew(parent, studio);
    if (!paths.isEmpty() && studio.session().isOpen())
        studio.session().importTakes(paths);
}

void SessionCommands::askForImport(QWidget* parent, Studio& studio) {
    import(parent, studio, askForTakes(parent, studio));
}

}  // namespace noctule::ui
