// SPDX-License-Identifier: Apache-2.0
// The mouse within a widget, without the screen's pointer: that one moves when the X server has time.
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

namespace noctule::ui::test {

inline void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons held = Qt::NoButton) {
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, held, {});
    QApplication::sendEvent(&widget, &move);
}

/// With the left button, in two steps.
inline void dragMouse(QWidget& widget, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&widget, Qt::LeftButton, {}, from);
    moveMouse(widget, from + (to - from) / 2, Qt::LeftButton);
    moveMouse(widget, to, Qt::LeftButton);
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, to);
}

}  // namespace noctule::ui::test
