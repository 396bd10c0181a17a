// SPDX-License-Identifier: Apache-2.0
// Recent sessions as rows of the start page: small picture, name and folder, performer, takes with their
// state, and when it was open last. Enter opens, Del takes the row off the list, the folder stays.
#pragma once

#include <QAbstractListModel>
#include <QHash>
#include <QListView>
#include <QPixmap>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>

#include "ui/style/ink.h"
#include "ui/views/session/recent_sessions.h"

namespace noctule::ui {

class RecentSessionModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { kFolder = Qt::UserRole, kSearchText, kPicture };

    explicit RecentSessionModel(RecentSessions& recent, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    const RecentSession& at(int row) const { return sessions_[static_cast<size_t>(row)]; }
    bool hasPicture(const QString& folder) const { return pictures_.contains(folder); }
    void setPicture(const QString& folder, const QImage& picture);

private:
    void follow();

    RecentSessions& recent_;
    std::vector<RecentSession> sessions_;
    QHash<QString, QImage> pictures_;
};

/// "7 takes, 4:19" and what is to be known about them, with its tone.
struct SessionStateWords {
    QString takes, state;
    Tone tone = Tone::kNeutral;
};
SessionStateWords stateWords(const RecentSession& session);

class RecentSessionDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

class SessionList : public QListView {
    Q_OBJECT
public:
    explicit SessionList(RecentSessions& recent, QWidget* parent = nullptr);

    void setFilter(const QString& text);
    RecentSessionModel& sessions() { return model_; }
    int shownRows() const { return filter_.rowCount(); }
    /// As tall as its rows: the page scrolls, not the list.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void folderWanted(const QString& folder);  ///< to be shown in the file manager
    void openRequested(const QString& folder);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    QString folderOf(const QModelIndex& index) const;

    RecentSessions& recent_;
    RecentSessionModel model_;
    QSortFilterProxyModel filter_;
};

}  // namespace noctule::ui
