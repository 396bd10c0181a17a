// SPDX-License-Identifier: Apache-2.0
// The takes of the session: state, name, length and stars. A click or Up and Down open one for review, 0 to
// 5 rate it, F2 renames it, files dropped on it are copied into the session.
#pragma once

#include <QListView>

#include "ui/views/take_list_model.h"

namespace noctule::ui {

class TakeList : public QListView {
    Q_OBJECT
public:
    explicit TakeList(ReviewContext& review, QWidget* parent = nullptr);

    /// Opens a take for review; damaged ones say why not.
    void openTake(int row);
    /// A field for its name, in place.
    void rename(int row);
    /// The chosen row is filled. Not while a row outside of the list is the one that matters.
    void setHighlights(bool highlights);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void notesWanted();  ///< of the chosen take, which is open
    void transferWanted(int take, noctule::ui::SessionModel::Transfer how);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// How many rows there is room for; the words of an empty list need more than one.
    int rowsShown(int most) const;
    std::optional<int> ratingAt(const QPoint& position) const;
    void chooseOpen();
    void showMenu(const QModelIndex& index, const QPoint& global);
    bool canRecover(int row) const;
    void showInFolder(int row);

    ReviewContext& review_;
    TakeListModel* takes_;
    bool rates_ = false;  ///< the button went down on the stars of a row
};

}  // namespace noctule::ui
