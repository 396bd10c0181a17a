// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/scroll_area.h"

#include <QApplication>
#include <QEvent>
#include <QScrollBar>

#include "ui/style/theme.h"

namespace noctule::ui {

ScrollArea::ScrollArea(QWidget* content, QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setAutoFillBackground(false);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now && widget() && widget()->isAncestorOf(now))
            ensureWidgetVisible(now, 0, Theme::get().px(12));
    });
    if (content) {
        setWidget(content);
        content->setAutoFillBackground(false);
    }
}

QSize ScrollArea::sizeHint() const {
    return widget() ? widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0)
                    : QScrollArea::sizeHint();
}

QSize ScrollArea::minimumSizeHint() const {
    const int content = widget() ? widget()->minimumSizeHint().width() : 0;
    return {content + verticalScrollBar()->sizeHint().width(), Theme::get().px(48)};
}

bool ScrollArea::eventFilter(QObject* object, QEvent* event) {
    if (object == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(object, event);
}

}  // namespace noctule::ui
