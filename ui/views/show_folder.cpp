// SPDX-License-Identifier: Apache-2.0
// Through xdg-open itself: QDesktopServices starts it and does not learn what became of it.
#include "ui/views/show_folder.h"

#include <QCoreApplication>
#include <QDir>
#include <QPointer>
#include <QProcess>

#include "ui/models/shared_context.h"

namespace noctule::ui {
namespace {

struct FolderWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ShowFolder)
};

void tellNoManager(SharedContext& shared, const QString& folder) {
    emit shared.failed(FolderWords::tr("No file manager could be started"),
                       FolderWords::tr("The folder is %1. Open it by hand, or install a file manager.")
                           .arg(QDir::toNativeSeparators(folder)),
                       About::kFile);
}

}  // namespace

void showFolder(SharedContext& shared, const QString& folder) {
    if (!QDir(folder).exists()) {
        emit shared.failed(FolderWords::tr("%1 is not there").arg(QDir::toNativeSeparators(folder)),
                           FolderWords::tr("It may have been moved, or its disk is not connected."),
                           About::kFile);
        return;
    }
    emit shared.settled(About::kFile);
    auto* opener = new QProcess;
    const QPointer<SharedContext> told(&shared);
    QObject::connect(opener, &QProcess::errorOccurred, opener, [=](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart && told)
            tellNoManager(*told, folder);
        opener->deleteLater();
    });
    QObject::connect(opener, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), opener,
                     [=](int code) {
                         if (code != 0 && told)  // xdg-open tries several, which may take long
                             tellNoManager(*told, folder);
                         opener->deleteLater();
                     });
    opener->start(QStringLiteral("xdg-open"), {folder});
}

}  // namespace noctule::ui
