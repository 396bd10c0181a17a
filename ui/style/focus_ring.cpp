// SPDX-License-Identifier: Apache-2.0
#include "ui/style/focus_ring.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

#include "ui/style/theme.h"

namespace noctule::ui {

namespace {

constexpr char kOwnMark[] = "noctule_own_focus_mark";
constexpr double kReach = 4;  // 2 px off and 2 px wide

bool isKeyboard(Qt::FocusReason reason) {
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
           reason == Qt::ShortcutFocusReason;
}

/// What a ring would go around: of a spin box's editor the spin box, of a window or page nothing.
QWidget* markedBy(QWidget* focus) {
    if (!focus || focus->isWindow() || focus->property(kOwnMark).toBool())
        return nullptr;
    if (focus->inherits("QMenuBar") || focus->inherits("QMenu"))
        return nullptr;
    return focus->focusPolicy() == Qt::NoFocus ? nullptr : focus;
}

}  // namespace

void setOwnFocusMark(QWidget& widget) {
    widget.setProperty(kOwnMark, true);
}

class FocusRing::Overlay : public QWidget {
public:
    explicit Overlay(QWidget* window) : QWidget(window) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
        setFocusPolicy(Qt::NoFocus);
        setObjectName("focus_ring");
    }

    double radius = 4;

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::get();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(theme.tokens().acc, theme.px(2)));
        const double half = theme.px(2) / 2.0;
        painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), radius, radius);
    }
};

FocusRing::FocusRing(Theme& theme, QApplication& application) : QObject(&theme) {
    application.installEventFilter(this);
    connect(&theme, &Theme::changed, this, &FocusRing::place);
    connect(&application, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

bool FocusRing::eventFilter(QObject* object, QEvent* event) {
    switch (event->type()) {
        case QEvent::FocusIn:
            by_keyboard_ = isKeyboard(static_cast<QFocusEvent*>(event)->reason());
            if (object == target_ || object == QApplication::focusWidget())
                follow(QApplication::focusWidget());
            break;
        case QEvent::MouseButtonPress:
            by_keyboard_ = false;
            hide();
            break;
        case QEvent::Move:
        case QEvent::Resize:
        case QEvent::Show:
        case QEvent::Hide:
        case QEvent::LayoutRequest:
            if (overlay_ && overlay_->isVisible() && object != overlay_ && object->isWidgetType())
                QMetaObject::invokeMethod(this, &FocusRing::place, Qt::QueuedConnection);
            break;
        default:
            break;
    }
    return false;
}

void FocusRing::follow(QWidget* widget) {
    target_ = by_keyboard_ ? markedBy(widget) : nullptr;
    place();
}

void FocusRing::hide() {
    if (overlay_)
        overlay_->hide();
}

void FocusRing::place() {
    if (!target_ || !target_->isVisible())
        return hide();
    QWidget* window = target_->window();
    if (!overlay_ || overlay_->parentWidget() != window) {
        delete overlay_;
        overlay_ = new Overlay(window);
    }
    const Theme& theme = Theme::get();
    const int reach = theme.px(kReach);
    QRect ring(target_->mapTo(window, QPoint(0, 0)), target_->size());
    ring.adjust(-reach, -reach, reach, reach);
    // In a scroll area the ring ends where the area ends; where the window ends it stays inside.
    for (QWidget* parent = target_->parentWidget(); parent && parent != window;
         parent = parent->parentWidget())
        if (qobject_cast<QAbstractScrollArea*>(parent->parentWidget()))
            ring &= QRect(parent->mapTo(window, QPoint(0, 0)), parent->size());
    ring &= window->rect();
    overlay_->radius = theme.px(6);
    overlay_->setGeometry(ring);
    overlay_->setVisible(!ring.isEmpty());
    overlay_->raise();
    overlay_->update();
}

}  // namespace noctule::ui
