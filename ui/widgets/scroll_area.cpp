// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/scroll_area.h"

#include <QApplication>
#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "ui/style/theme.h"

namespace noctule::ui {

ScrollArea::ScrollArea(QWidget* content, QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setAutoFillBackground(false);
    connect(qApp, &QApplication::focusChanged, this, &ScrollArea::follow);
    connect(&Theme::get(), &Theme::changed, this, [this] { is_outdated_ |= !isVisible(); });
    if (content) {
        setWidget(content);
        content->setAutoFillBackground(false);
    }
}

/// Qt also moves the focus by itself, where a page is shown or what had it goes: nobody looks for it then.
void ScrollArea::follow(QWidget* before, QWidget* now) {
    const bool by_itself = is_just_shown_ || (before && !(before->isVisible() && before->isEnabled()));
    if (now && !by_itself && widget() && widget()->isAncestorOf(now))
        ensureWidgetVisible(now, 0, Theme::get().px(12));
}

bool ScrollArea::focusNextPrevChild(bool next) {
    return QAbstractScrollArea::focusNextPrevChild(next);  // QScrollArea's would follow in every case
}

void ScrollArea::showEvent(QShowEvent* event) {
    is_just_shown_ = true;
    if (std::exchange(is_outdated_, false))
        askAllSizes();
    QMetaObject::invokeMethod(
        this, [this] { is_just_shown_ = false; }, Qt::QueuedConnection);
    QScrollArea::showEvent(event);
}

/// Layouts that are not seen tell nobody of another size, and the area would stay as wide as with larger
/// text.
void ScrollArea::askAllSizes() {
    if (!widget())
        return;
    for (QLayout* layout : widget()->findChildren<QLayout*>())
        layout->invalidate();
    updateGeometry();
}

QSize ScrollArea::sizeHint() const {
    return widget() ? widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0)
                    : QScrollArea::sizeHint();
}

QSize ScrollArea::minimumSizeHint() const {
    const int content = widget() ? widget()->minimumSizeHint().width() : 0;
    return {content + verticalScrollBar()->sizeHint().width(), Theme::get().px(48)};
}

int ScrollArea::cutRow_px() const {
    QLayout* rows = widget() ? widget()->layout() : nullptr;
    if (!rows)
        return 0;
    rows->activate();
    const int seen = viewport()->height();
    int end = seen;
    for (int i = 0; i < rows->count(); ++i)
        if (const QRect part = rows->itemAt(i)->geometry(); part.top() < seen && part.bottom() >= seen)
            end = std::min(end, part.top());
    return seen - end;
}

bool ScrollArea::eventFilter(QObject* object, QEvent* event) {
    if (object == widget() && event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        fitContent();
    }
    return QScrollArea::eventFilter(object, event);
}

void ScrollArea::resizeEvent(QResizeEvent* event) {
    fitContent();
    QScrollArea::resizeEvent(event);
}

/// Qt never makes the content lower than its texts would be at another width, and scrolls over nothing.
void ScrollArea::fitContent() {
    const QLayout* layout = widget() ? widget()->layout() : nullptr;
    if (!layout || !layout->hasHeightForWidth()) {
        // What had wrapped texts may be hidden now; its height is not kept.
        if (std::exchange(is_fitted_, false) && widget())
            widget()->setMinimumHeight(0);
        return;
    }
    is_fitted_ = true;
    const QSize room = maximumViewportSize();
    const int without_bar = widget()->heightForWidth(room.width());
    const int bar = verticalScrollBar()->sizeHint().width();
    widget()->setMinimumHeight(without_bar <= room.height() ? without_bar
                                                            : widget()->heightForWidth(room.width() - bar));
}

}  // namespace noctule::ui
