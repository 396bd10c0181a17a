// SPDX-License-Identifier: Apache-2.0
// All dialogs that ask for files and folders. Each kind of file has a folder of its own, kept in the
// settings: where one was chosen last, else the usual one of its kind, else the open session's, else
// Documents. A file to write does not go into another session because the last one did.
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace noctule::ui {

struct FileChoice {
    QString kind;      ///< name in the settings: "calibrations"
    QString title;     ///< of the dialog
    QString filter{};  ///< as QFileDialog has it; of files only
    QString name{};    ///< proposed for a file to write
    QString usual{};   ///< folder where none was chosen before; empty: the session's
    QString at{};      ///< what is chosen now, file or folder: the dialog begins there; empty: as above

    // Empty: cancelled.
    QString toOpen(QWidget* parent) const;
    QStringList severalToOpen(QWidget* parent) const;
    QString toSave(QWidget* parent) const;
    QString folder(QWidget* parent) const;

    /// Where the dialog begins.
    QString start() const;
    /// `chosen`: a file or folder; the dialog begins beside it the next time.
    void remember(const QString& chosen) const;

    /// Empty: none is open.
    static void setSession(const QString& folder);
};

}  // namespace noctule::ui
