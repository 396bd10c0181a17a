// SPDX-License-Identifier: Apache-2.0
// Mouse and keys of the 3D view.
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <QWheelEvent>

#include "core/render/picking.h"
#include "ui/scene/scene_parts.h"

namespace noctule::ui {

namespace {

constexpr double kPickReach_px = 12;
constexpr double kClick_px = 4;
constexpr double kNudge_m = 0.001, kBigNudge_m = 0.01;

/// Lists take letters and digits too: rating of takes, search by first letter.
bool takesPlainKeys(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTextEdit*>(widget) ||
           qobject_cast<const QPlainTextEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractItemView*>(widget);
}

}  // namespace

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parts_->canvas)
        return canvasEvent(*event);
    if (event->type() == QEvent::KeyPress && isVisible() && isActiveWindow() &&
        watched == QApplication::focusWidget() && watched != this &&
        window()->isAncestorOf(QApplication::focusWidget()) && !takesPlainKeys(QApplication::focusWidget()))
        return actOnKey(*static_cast<QKeyEvent*>(event));
    return QWidget::eventFilter(watched, event);
}

bool SceneView::canvasEvent(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress:
            return mousePress(static_cast<QMouseEvent&>(event));
        case QEvent::MouseMove:
            return mouseMove(static_cast<QMouseEvent&>(event));
        case QEvent::MouseButtonRelease:
            return mouseRelease(static_cast<QMouseEvent&>(event));
        case QEvent::Wheel:
            parts_->untouched = false;
            parts_->control->wheel(static_cast<QWheelEvent&>(event));
            return true;
        default:
            return false;
    }
}

bool SceneView::mousePress(const QMouseEvent& event) {
    Parts& parts = *parts_;
    setFocus(Qt::MouseFocusReason);
    if (parts.control->press(event)) {
        parts.untouched = false;
        return true;
    }
    if (event.button() != Qt::LeftButton)
        return false;
    if (parts.figure && parts.figure->beginDrag(parts.screen(), parts.onSurface(event.localPos()))) {
        refresh();
        return true;
    }
    parts.pressed_at = event.localPos();
    return true;
}

bool SceneView::mouseMove(const QMouseEvent& event) {
    Parts& parts = *parts_;
    if (parts.control->move(event))
        return true;
    if (!parts.figure)
        return false;
    const Eigen::Vector2d at_px = parts.onSurface(event.localPos());
    if (!parts.figure->isDragging()) {
        const GizmoPart hot = parts.figure->hover(parts.screen(), at_px);
        parts.canvas->setCursor(hot == GizmoPart::kNone ? Qt::ArrowCursor : Qt::PointingHandCursor);
        refresh();
        return false;
    }
    const PartPlacement placement = parts.figure->dragTo(parts.screen(), at_px);
    refresh();
    emit placementDragged(parts.figure->chosen(), placement.p_segment_m, placement.q_segment);
    return true;
}

bool SceneView::mouseRelease(const QMouseEvent& event) {
    Parts& parts = *parts_;
    if (parts.control->release(event))
        return true;
    if (parts.figure && parts.figure->isDragging()) {
        parts.figure->endDrag();
        refresh();
        emit dragEnded();
        return true;
    }
    if (event.button() != Qt::LeftButton || !parts.pressed_at)
        return false;
    const QPointF moved = event.localPos() - *parts.pressed_at;
    parts.pressed_at.reset();
    if (std::hypot(moved.x(), moved.y()) <= kClick_px)
        pick(event.localPos());
    return true;
}

void SceneView::pick(const QPointF& at) {
    Parts& parts = *parts_;
    if (!parts.composed.hasBody() || !parts.layers.has(SceneLayer::kBoards))
        return;
    const Eigen::Vector2d at_px = parts.onSurface(at);
    const auto board = pointUnderPixel(parts.composed.boardPoints(), parts.screen(), at_px, kPickReach_px);
    const auto source = pointUnderPixel(parts.composed.sourcePoints(), parts.screen(), at_px, kPickReach_px);
    SuitPart part;
    if (board && (!source || board->distance_px <= source->distance_px))
        part = {SuitPart::Kind::kBoard, static_cast<int>(board->index)};
    else if (source)
        part = {SuitPart::Kind::kSource, static_cast<int>(source->index)};
    if (parts.figure) {
        parts.figure->choose(part);
        refresh();
        emit partChosen(part);
        return;
    }
    Selection& selection = review_.selection();
    if (part.kind == SuitPart::Kind::kBoard)
        selection.setPair(selection.source(), part.index);
    else if (part.kind == SuitPart::Kind::kSource)
        selection.setPair(part.index, selection.board());
    else
        selection.setPair(-1, -1);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    if (!actOnKey(*event) && !nudge(*event))
        QWidget::keyPressEvent(event);
}

bool SceneView::actOnKey(const QKeyEvent& event) {
    const bool shift = event.modifiers() == Qt::ShiftModifier;
    if (!parts_->canvas || (event.modifiers() & ~Qt::KeypadModifier && !(shift && event.key() == Qt::Key_F)))
        return false;
    switch (event.key()) {
        case Qt::Key_1:
            setView(CameraView::kFront);
            return true;
        case Qt::Key_3:
            setView(CameraView::kSide);
            return true;
        case Qt::Key_7:
            setView(CameraView::kTop);
            return true;
        case Qt::Key_F:
            shift ? setFollow(!follows()) : frameBody();
            return true;
        case Qt::Key_R:
            toggle(SceneLayer::kRays);
            return true;
        case Qt::Key_G:
            toggle(SceneLayer::kGhost);
            return true;
        default:
            return false;
    }
}

bool SceneView::nudge(const QKeyEvent& event) {
    Parts& parts = *parts_;
    if (!parts.figure || parts.figure->chosen().kind == SuitPart::Kind::kNone)
        return false;
    const double step = event.modifiers() & Qt::ShiftModifier ? kBigNudge_m : kNudge_m;
    const int key = event.key();
    const double right = key == Qt::Key_Right ? step : key == Qt::Key_Left ? -step : 0;
    const double up = key == Qt::Key_Up ? step : key == Qt::Key_Down ? -step : 0;
    if (right == 0 && up == 0)
        return false;
    const PartPlacement placement = parts.figure->nudge(parts.control->camera(), right, up);
    refresh();
    emit placementDragged(parts.figure->chosen(), placement.p_segment_m, placement.q_segment);
    emit dragEnded();
    return true;
}

}  // namespace noctule::ui
