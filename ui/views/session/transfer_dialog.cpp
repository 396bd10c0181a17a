// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/transfer_dialog.h"

#include <QBoxLayout>
#include <QDir>
#include <QFileInfo>
#include <QListWidget>

#include "ui/models/file_choice.h"
#include "ui/models/session_marker.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/session/recent_sessions.h"
#include "ui/views/session/session_commands.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

constexpr int kSessionsWide = 440, kSessionsHigh = 200;

bool isMove(SessionModel::Transfer how) {
    return how == SessionModel::Transfer::kMove;
}

}  // namespace

TransferDialog::TransferDialog(SharedContext& shared, const QString& take, SessionModel::Transfer how,
                               QWidget* parent)
    : DialogFrame(
          (isMove(how) ? tr("Move %1 to another session") : tr("Copy %1 to another session")).arg(take),
          tr("Its results, markers, notes, rating and calibration go with it. Where its name is taken, "
             "both takes are kept."),
          isMove(how) ? tr("Move") : tr("Copy"), parent),
      shared_(shared),
      sessions_(new QListWidget) {
    sessions_->setAccessibleName(tr("Session"));
    keepSize(*sessions_, kSessionsWide, kSessionsHigh);
    content()->addWidget(sessions_);
    auto* other = makeButton(ButtonKind::kText, tr("Another session"), "folder");
    auto* row = addRow(content());
    row->addWidget(other);
    row->addStretch();
    const RecentSessions known(shared.settings(), shared.jobs());
    for (const RecentSession& recent : known.all())
        if (!isOpenHere(recent.folder) && SessionCommands::isSession(recent.folder))
            addSession(sessions_->count(), recent.folder);
    connect(other, &QPushButton::clicked, this, &TransferDialog::askForFolder);
    connect(sessions_, &QListWidget::currentRowChanged, this, &TransferDialog::refresh);
    connect(sessions_, &QListWidget::itemDoubleClicked, this, &TransferDialog::accept);
    refresh();
}

bool TransferDialog::isOpenHere(const QString& folder) const {
    return shared_.session().isOpen() &&
           QDir(folder) == QDir(QString::fromStdString(shared_.session().session().folder.string()));
}

void TransferDialog::addSession(int row, const QString& folder) {
    auto* item = new QListWidgetItem(
        tr("%1   in %2", "name of a session, folder")
            .arg(SessionModel::nameOfSession(folder), QDir::toNativeSeparators(QFileInfo(folder).path())));
    item->setData(Qt::UserRole, folder);
    item->setToolTip(QDir::toNativeSeparators(folder));
    sessions_->insertItem(row, item);
}

QString TransferDialog::folder() const {
    const QListWidgetItem* chosen = sessions_->currentItem();
    return chosen ? chosen->data(Qt::UserRole).toString() : QString();
}

QString TransferDialog::choose(const QString& folder) {
    if (isOpenHere(folder))
        return tr("The take is in this session already. Choose another one.");
    if (!SessionCommands::isSession(folder))
        return tr("%1 is no session. Choose the folder of one; it holds session.json.")
            .arg(QDir::toNativeSeparators(folder));
    int row = 0;
    while (row < sessions_->count() &&
           QDir(sessions_->item(row)->data(Qt::UserRole).toString()) != QDir(folder))
        ++row;
    if (row == sessions_->count())
        addSession(row = 0, QDir::cleanPath(folder));
    sessions_->setCurrentRow(row);
    return {};
}

void TransferDialog::askForFolder() {
    const QString folder =
        FileChoice{.kind = "last_session", .title = tr("Choose a session"), .usual = shared_.sessionsFolder()}
            .folder(this);
    if (folder.isEmpty())
        return;
    setProblem(choose(folder));
    fitHeight();
}

void TransferDialog::refresh() {
    actionButton()->setDisabledBecause(folder().isEmpty() ? tr("Choose a session.") : QString());
    setProblem({});
}

/// What another window has open it saves from memory: what came from here would be lost from its list.
void TransferDialog::accept() {
    if (folder().isEmpty())
        return;
    if (SessionMarker::isOpenElsewhere(folder())) {
        setProblem(tr("“%1” is open in another window. Close it there first.")
                       .arg(SessionModel::nameOfSession(folder())));
        fitHeight();
        return;
    }
    DialogFrame::accept();
}

}  // namespace noctule::ui
