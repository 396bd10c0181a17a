// SPDX-License-Identifier: Apache-2.0
#include "ui/models/file_choice.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace noctule::ui {
namespace {

QString folder_of_session;

bool isThere(const QString& folder) {
    return !folder.isEmpty() && QFileInfo(folder).isDir();
}

/// While a session is open.
bool isOfAnotherSession(const QString& folder) {
    QDir above(folder);
    bool is_session = above.exists("session.json");
    while (!is_session && above.cdUp())
        is_session = above.exists("session.json");
    return is_session && !folder_of_session.isEmpty() &&
           above.canonicalPath() != QDir(folder_of_session).canonicalPath();
}

}  // namespace

void FileChoice::setSession(const QString& folder) {
    folder_of_session = folder;
}

QString FileChoice::start() const {
    if (!at.isEmpty())
        return at;
    QString last = QSettings().value("folders/" + kind).toString();
    if (!name.isEmpty() && isThere(last) && isOfAnotherSession(last))
        last.clear();
    for (const QString& folder : {last, usual, folder_of_session,
                                  QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)})
        if (isThere(folder))
            return folder;
    return QDir::homePath();
}

void FileChoice::remember(const QString& chosen) const {
    if (!chosen.isEmpty())
        QSettings().setValue("folders/" + kind, QFileInfo(chosen).absolutePath());
}

QString FileChoice::toOpen(QWidget* parent) const {
    const QString path = QFileDialog::getOpenFileName(parent, title, start(), filter);
    remember(path);
    return path;
}

QStringList FileChoice::severalToOpen(QWidget* parent) const {
    const QStringList paths = QFileDialog::getOpenFileNames(parent, title, start(), filter);
    remember(paths.value(0));
    return paths;
}

QString FileChoice::toSave(QWidget* parent) const {
    const QString path = QFileDialog::getSaveFileName(parent, title, QDir(start()).filePath(name), filter);
    remember(path);
    return path;
}

QString FileChoice::folder(QWidget* parent) const {
    const QString path = QFileDialog::getExistingDirectory(parent, title, start());
    remember(path);
    return path;
}

}  // namespace noctule::ui
