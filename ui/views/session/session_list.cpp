// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/session_list.h"

#include <QContextMenuEvent>
#include <QDir>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>

#include "ui/style/focus_ring.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {

RecentSessionModel::RecentSessionModel(RecentSessions& recent, QObject* parent)
    : QAbstractListModel(parent), recent_(recent), sessions_(recent.all()) {
    connect(&recent_, &RecentSessions::changed, this, &RecentSessionModel::follow);
}

void RecentSessionModel::follow() {
    beginResetModel();
    sessions_ = recent_.all();
    endResetModel();
}

int RecentSessionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(sessions_.size());
}

QVariant RecentSessionModel::data(const QModelIndex& index, int role) const {
    const RecentSession& session = at(index.row());
    const SessionStateWords words = stateWords(session);
    switch (role) {
        case Qt::DisplayRole:
            return session.name;
        case Qt::ToolTipRole:
            return QDir::toNativeSeparators(session.folder);
        case Qt::AccessibleTextRole:
            return QStringList{session.name, session.performer, words.takes, words.state,
                               dateText(session.opened)}
                .join(QStringLiteral(", "));
        case kFolder:
            return session.folder;
        case kSearchText:
            return QStringList{session.name, session.folder, session.performer, session.take_names.join(' ')}
                .join(' ');
        case kPicture:
            return pictures_.value(session.folder);
        default:
            return {};
    }
}

void RecentSessionModel::setPicture(const QString& folder, const QImage& picture) {
    pictures_[folder] = picture;
    for (int row = 0; row < rowCount(); ++row)
        if (at(row).folder == folder)
            emit dataChanged(index(row), index(row), {kPicture});
}

SessionStateWords stateWords(const RecentSession& session) {
    if (!session.known)
        return {};
    if (session.can_rebuild)
        return {{}, RecentSessionModel::tr("Can be rebuilt from its takes"), Tone::kError};
    if (!session.problem.isEmpty())
        return {{}, session.problem, Tone::kWarn};
    SessionStateWords words;
    if (session.takes == 0)
        return {RecentSessionModel::tr("No takes yet"), {}, Tone::kNeutral};
    words.takes =
        RecentSessionModel::tr("%n take(s), %1", "number of takes, their time together", session.takes)
            .arg(timeText(session.duration_s, 0));
    if (session.damaged > 0) {
        words.state = RecentSessionModel::tr("%n damaged", "takes", session.damaged);
        words.tone = Tone::kError;
    } else if (const auto broken = std::count_if(session.interrupted.begin(), session.interrupted.end(),
                                                 [](const InterruptedTake& take) { return !take.recovered; });
               broken > 0) {
        words.state = RecentSessionModel::tr("%n interrupted", "takes", static_cast<int>(broken));
        words.tone = Tone::kWarn;
    } else if (session.unprocessed > 0) {
        words.state = RecentSessionModel::tr("%n not processed", "takes", session.unprocessed);
        words.tone = Tone::kNeutral;
    } else {
        words.state = RecentSessionModel::tr("Processed");
        words.tone = Tone::kOk;
    }
    return words;
}

SessionList::SessionList(RecentSessions& recent, QWidget* parent)
    : QListView(parent), recent_(recent), model_(recent) {
    filter_.setSourceModel(&model_);
    filter_.setFilterRole(RecentSessionModel::kSearchText);
    filter_.setFilterCaseSensitivity(Qt::CaseInsensitive);
    setModel(&filter_);
    setItemDelegate(new RecentSessionDelegate(this));
    setAccessibleName(tr("Recent sessions"));
    setOwnFocusMark(*this);
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    viewport()->setAutoFillBackground(false);
    connect(this, &QListView::activated, this,
            [this](const QModelIndex& index) { emit openRequested(folderOf(index)); });
    const auto rows_changed = [this] {
        if (!currentIndex().isValid() && filter_.rowCount() > 0)
            setCurrentIndex(filter_.index(0, 0));
        updateGeometry();
    };
    connect(&filter_, &QAbstractItemModel::modelReset, this, rows_changed);
    connect(&filter_, &QAbstractItemModel::layoutChanged, this, rows_changed);
    connect(&filter_, &QAbstractItemModel::rowsInserted, this, rows_changed);
    connect(&filter_, &QAbstractItemModel::rowsRemoved, this, rows_changed);
    connect(&Theme::get(), &Theme::changed, this, [this] { scheduleDelayedItemsLayout(), updateGeometry(); });
    rows_changed();
}

void SessionList::setFilter(const QString& text) {
    filter_.setFilterFixedString(text.trimmed());
    updateGeometry();
}

QSize SessionList::sizeHint() const {
    int height = 0;
    for (int row = 0; row < filter_.rowCount(); ++row)
        height += sizeHintForRow(row);
    return {Theme::get().px(480), height};
}

QSize SessionList::minimumSizeHint() const {
    return {Theme::get().px(360), sizeHint().height()};
}

QString SessionList::folderOf(const QModelIndex& index) const {
    return index.data(RecentSessionModel::kFolder).toString();
}

void SessionList::keyPressEvent(QKeyEvent* event) {
    const QString folder = folderOf(currentIndex());
    if (event->key() == Qt::Key_Delete && !folder.isEmpty())
        recent_.remove(folder);
    else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !folder.isEmpty())
        emit openRequested(folder);
    else
        QListView::keyPressEvent(event);
}

void SessionList::contextMenuEvent(QContextMenuEvent* event) {
    const QModelIndex index =
        event->reason() == QContextMenuEvent::Keyboard ? currentIndex() : indexAt(event->pos());
    const QString folder = folderOf(index);
    if (folder.isEmpty())
        return;
    QMenu menu(this);
    menu.addAction(tr("Open"), this, [this, folder] { emit openRequested(folder); });
    menu.addAction(tr("Show folder"), this, [this, folder] { emit folderWanted(folder); });
    menu.addSeparator();
    menu.addAction(tr("Take off this list"), this, [this, folder] { recent_.remove(folder); })
        ->setShortcut(QKeySequence(Qt::Key_Delete));
    menu.exec(event->globalPos());
}

}  // namespace noctule::ui
