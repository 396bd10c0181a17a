// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/noticed_page.h"

#include <QCursor>
#include <QEvent>
#include <QVBoxLayout>

#include "ui/views/scaled_layout.h"

namespace noctule::ui {

NoticedPage::NoticedPage(QWidget* notices, QWidget* page, QWidget* parent)
    : QWidget(parent), notices_(notices), page_(page), room_(new QWidget) {
    notices_->setParent(this);  // first in the order of Tab
    auto* column = makeColumn(this);
    column->addWidget(room_);
    column->addWidget(page_, 1);
    notices_->raise();
    for (QWidget* part : {notices_, page_})
        part->installEventFilter(this);
    arrange();
}

bool NoticedPage::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool is_sized =
        type == QEvent::LayoutRequest || type == QEvent::ShowToParent || type == QEvent::HideToParent;
    if (watched == notices_ && is_sized)
        arrange();
    // What the mouse has left for is told next.
    if (type == QEvent::Leave)
        QMetaObject::invokeMethod(this, &NoticedPage::arrange, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

void NoticedPage::resizeEvent(QResizeEvent*) {
    arrange();
}

void NoticedPage::arrange() {
    const int needed_px = notices_->isHidden()            ? 0
                          : notices_->hasHeightForWidth() ? notices_->heightForWidth(width())
                                                          : notices_->sizeHint().height();
    const bool stays = page_->underMouse() || (lie_below_ && notices_->underMouse());
    if (!stays || needed_px == 0)
        lie_below_ = false;
    if (!stays)
        room_->setFixedHeight(needed_px);
    else if (!lie_below_ && needed_px > room_->maximumHeight())
        lie_below_ = QRect(0, 0, width(), needed_px).contains(mapFromGlobal(QCursor::pos()));
    notices_->setGeometry(0, lie_below_ ? height() - needed_px : 0, width(), needed_px);
}

}  // namespace noctule::ui
