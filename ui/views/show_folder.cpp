// SPDX-License-Identifier: Apache-2.0
// Through xdg-open itself: QDesktopServices starts it and does not learn what became of it.
#include "ui/views/show_folder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QProcess>

#include "ui/models/shared_context.h"

namespace noctule::ui {
namespace {

struct FolderWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ShowFolder)
};

/// `title` and `remedy`: what is told where no program opens it.
void openByDesktop(SharedContext& shared, const QString& path, const QString& title, const QString& remedy) {
    if (!QFileInfo::exists(path)) {
        emit shared.failed(FolderWords::tr("%1 is not there").arg(QDir::toNativeSeparators(path)),
                           FolderWords::tr("It may have been moved, or its disk is not connected."),
                           About::kFile);
        return;
    }
    emit shared.settled(About::kFile);
    auto* opener = new QProcess;
    const auto tell = [told = QPointer(&shared), title, remedy] {
        if (told)
            emit told->failed(title, remedy, About::kFile);
    };
    QObject::connect(opener, &QProcess::errorOccurred, opener, [=](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            tell();
        opener->deleteLater();
    });
    QObject::connect(opener, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), opener,
                     [=](int code) {
                         if (code != 0)  // xdg-open tries several, which may take long
                             tell();
                         opener->deleteLater();
                     });
    opener->start(QStringLiteral("xdg-open"), {path});
}

}  // namespace

void showFolder(SharedContext& shared, const QString& folder) {
    openByDesktop(shared, folder, FolderWords::tr("No file manager could be started"),
                  FolderWords::tr("The folder is %1. Open it by hand, or install a file manager.")
                      .arg(QDir::toNativeSeparators(folder)));
}

void openFile(SharedContext& shared, const QString& path) {
    openByDesktop(shared, path, FolderWords::tr("No program opened %1").arg(QFileInfo(path).fileName()),
                  FolderWords::tr("The file is %1. Open it by hand, or install a program for such files.")
                      .arg(QDir::toNativeSeparators(path)));
}

}  // namespace noctule::ui
