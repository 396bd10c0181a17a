// SPDX-License-Identifier: Apache-2.0
#include "ui/views/take_list.h"

#include <QContextMenuEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QUrl>
#include <utility>

#include "ui/language/core_words.h"
#include "ui/models/session_marker.h"
#include "ui/style/theme.h"
#include "ui/views/show_folder.h"
#include "ui/views/take_delegate.h"

namespace noctule::ui {
namespace {

constexpr int kEmptyRows = 3, kMostRows = 10;

/// Take files among what is dragged.
QStringList takeFiles(const QMimeData& dragged) {
    QStringList paths;
    for (const QUrl& url : dragged.urls())
        if (url.isLocalFile() && url.toLocalFile().endsWith(".noctule", Qt::CaseInsensitive))
            paths += url.toLocalFile();
    return paths;
}

}  // namespace

TakeList::TakeList(ReviewContext& review, QWidget* parent)
    : QListView(parent), review_(review), takes_(new TakeListModel(review, this)) {
    setModel(takes_);
    setItemDelegate(new TakeDelegate(this));
    setFrameShape(NoFrame);
    setUniformItemSizes(true);
    setEditTriggers(NoEditTriggers);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAcceptDrops(true);
    viewport()->setAcceptDrops(true);
    setAccessibleName(tr("Takes"));
    connect(this, &QListView::activated, this, [this](const QModelIndex& index) { openTake(index.row()); });
    connect(this, &QListView::clicked, this, [this](const QModelIndex& index) {
        if (!std::exchange(rates_, false))
            openTake(index.row());
    });
    connect(&review.take(), &TakeDocument::opened, this, &TakeList::chooseOpen);
    connect(&review.shared().session(), &SessionModel::opened, viewport(), QOverload<>::of(&QWidget::update));
    connect(takes_, &QAbstractItemModel::modelReset, this, &TakeList::chooseOpen);
    connect(&Theme::get(), &Theme::changed, this, [this] { doItemsLayout(), updateGeometry(); });
    chooseOpen();
}

void TakeList::chooseOpen() {
    if (const int row = takes_->openRow(); row >= 0)
        setCurrentIndex(takes_->index(row));
    else if (review_.take().isOpen())  // one of no session
        setCurrentIndex({});
    updateGeometry();
}

void TakeList::openTake(int row) {
    const SessionTake& take = takes_->take(row);
    if (take.is_torn) {
        emit review_.shared().tornTake(review_.shared().session().takePath(row), coreWords(take.problem));
        return;
    }
    if (take.state == TakeState::kDamaged) {
        emit review_.shared().failed(
            tr("%1 cannot be opened: %2").arg(QString::fromStdString(take.name), coreWords(take.problem)),
            tr("The file stays where it is; nothing in it is changed."), About::kTake);
        return;
    }
    const QString path = review_.shared().session().takePath(row);
    review_.shared().session().setCurrentTake(row);
    if (row != takes_->openRow() && review_.take().path() != path)
        review_.take().open(path, take.shown_result);
}

void TakeList::rename(int row) {
    edit(takes_->index(row));
}

void TakeList::setHighlights(bool highlights) {
    const SelectionMode mode = highlights ? SingleSelection : NoSelection;
    if (mode == selectionMode())
        return;
    setSelectionMode(mode);
    if (highlights)
        setCurrentIndex(currentIndex());
    else
        clearSelection();
}

int TakeList::rowsShown(int most) const {
    return takes_->rowCount() > 0 ? std::min(takes_->rowCount(), most) : kEmptyRows;
}

QSize TakeList::sizeHint() const {
    return {Theme::get().px(216), rowsShown(kMostRows) * Theme::get().px(TakeDelegate::kRow)};
}

QSize TakeList::minimumSizeHint() const {
    return {Theme::get().px(160), rowsShown(kEmptyRows) * Theme::get().px(TakeDelegate::kRow)};
}

void TakeList::keyPressEvent(QKeyEvent* event) {
    const int rating = event->key() - Qt::Key_0;
    const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (plain && rating >= 0 && rating <= 5 && currentIndex().isValid())
        review_.shared().session().rate(currentIndex().row(), rating);
    else if (plain && event->key() == Qt::Key_Delete && currentIndex().isValid())
        review_.shared().session().trashTake(currentIndex().row());
    else if (plain && event->key() == Qt::Key_F2 && currentIndex().isValid())
        rename(currentIndex().row());
    else if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Left || event->key() == Qt::Key_Right ||
             event->key() == Qt::Key_Home || event->key() == Qt::Key_End ||
             !event->text().trimmed().isEmpty())
        event->ignore();  // the page plays, steps and marks with these
    else {
        const int before = currentIndex().row();
        QListView::keyPressEvent(event);
        if (currentIndex().isValid() && currentIndex().row() != before)
            openTake(currentIndex().row());  // what is highlighted is what is open
    }
}

std::optional<int> TakeList::ratingAt(const QPoint& position) const {
    const QModelIndex index = indexAt(position);
    return index.isValid() ? TakeDelegate::ratingAt(visualRect(index), position) : std::nullopt;
}

/// Stars and the menu are of the row below the pointer, whichever is chosen.
void TakeList::mousePressEvent(QMouseEvent* event) {
    const auto rating = event->button() == Qt::LeftButton ? ratingAt(event->pos()) : std::nullopt;
    rates_ = rating.has_value();
    if (rating) {
        const int row = indexAt(event->pos()).row();
        review_.shared().session().rate(row, *rating == takes_->take(row).rating ? 0 : *rating);
    } else if (event->button() == Qt::LeftButton) {
        QListView::mousePressEvent(event);
    }
}

void TakeList::mouseDoubleClickEvent(QMouseEvent* event) {
    if (ratingAt(event->pos()))
        mousePressEvent(event);
    else
        QListView::mouseDoubleClickEvent(event);
}

void TakeList::mouseMoveEvent(QMouseEvent* event) {
    if (!rates_ || event->buttons() == Qt::NoButton)
        QListView::mouseMoveEvent(event);
}

void TakeList::contextMenuEvent(QContextMenuEvent* event) {
    const bool by_keyboard = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = by_keyboard ? currentIndex() : indexAt(event->pos());
    if (index.isValid())
        showMenu(index,
                 by_keyboard ? viewport()->mapToGlobal(visualRect(index).bottomLeft()) : event->globalPos());
}

void TakeList::showMenu(const QModelIndex& index, const QPoint& global) {
    QMenu menu(this);
    const int row = index.row();
    menu.addAction(tr("Open"), this, [this, row] { openTake(row); });
    if (canRecover(row))
        menu.addAction(takes_->take(row).is_torn ? tr("Save what can be read") : tr("Recover"), this,
                       [this, row] { review_.shared().session().recover(row); });
    menu.addAction(tr("Rename"), this, [this, row] { rename(row); })->setShortcut(Qt::Key_F2);
    QMenu* rating = menu.addMenu(tr("Rating"));
    for (int stars = 0; stars <= 5; ++stars) {
        QAction* action =
            rating->addAction(stars == 0 ? tr("None") : tr("%n stars", nullptr, stars),
                              [this, row, stars] { review_.shared().session().rate(row, stars); });
        action->setCheckable(true);
        action->setChecked(stars == takes_->take(row).rating);
        action->setShortcut(QKeySequence(Qt::Key_0 + stars));
    }
    menu.addAction(tr("Notes"), this, [this, row] {
        openTake(row);
        emit notesWanted();
    });
    menu.addAction(tr("Show in folder"), this, [this, row] { showInFolder(row); });
    menu.addSeparator();
    menu.addAction(tr("Move to session…"), this,
                   [this, row] { emit transferWanted(row, SessionModel::Transfer::kMove); });
    menu.addAction(tr("Copy to session…"), this,
                   [this, row] { emit transferWanted(row, SessionModel::Transfer::kCopy); });
    QAction* trash =
        menu.addAction(tr("Move to trash"), this, [this, row] { review_.shared().session().trashTake(row); });
    trash->setShortcut(QKeySequence::Delete);
    menu.exec(global);
}

/// What another program has open it may be recording just now.
bool TakeList::canRecover(int row) const {
    return takes_->take(row).canRecover() && !SessionMarker::isOpenElsewhere(QString::fromStdString(
                                                 review_.shared().session().session().folder.string()));
}

void TakeList::showInFolder(int row) {
    const QFileInfo take(review_.shared().session().takePath(row));
    showFolder(review_.shared(), take.path());
}

void TakeList::dragEnterEvent(QDragEnterEvent* event) {
    if (review_.shared().session().isOpen() && !takeFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void TakeList::dragMoveEvent(QDragMoveEvent* event) {
    event->acceptProposedAction();
}

void TakeList::dropEvent(QDropEvent* event) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
    review_.shared().session().importTakes(takeFiles(*event->mimeData()));
}

void TakeList::paintEvent(QPaintEvent* event) {
    QListView::paintEvent(event);
    if (takes_->rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setFont(Theme::get().font(TextRole::kSecondary));
    painter.setPen(Theme::get().tokens().t3);
    const int inset = Theme::get().px(12);
    painter.drawText(viewport()->rect().adjusted(inset, inset / 2, -inset, 0),
                     Qt::AlignLeft | Qt::TextWordWrap,
                     review_.shared().session().isOpen()
                         ? tr("Takes appear here as they are recorded. Drop take files here to "
                              "copy them into the session.")
                         : tr("No session is open."));
}

}  // namespace noctule::ui
