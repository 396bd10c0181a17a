// SPDX-License-Identifier: Apache-2.0
// Where a window or a dialog may stand: never larger than what the desktop leaves free, frame and title bar
// included.
#pragma once

#include <QRect>
#include <QSize>

class QWidget;

namespace noctule::ui {

struct WindowPlace {
    QRect content;           ///< without the frame
    bool maximised = false;  ///< it had to be made smaller
};

/// `wanted` within `available`, in pixels of the desktop: moved inside first, then made smaller.
WindowPlace placeWithin(const QRect& wanted, const QRect& available);

/// What the screen of the window leaves free, without the desktop's panels.
QRect freeRoom(const QWidget& window);

/// The largest size of a dialog: that of the window it belongs to, as far as the screen has room.
QSize roomOf(const QWidget& dialog);

/// Makes it `wanted`, in pixels, or as large as its room; grown, it stays on the screen.
void placeDialog(QWidget& dialog, const QSize& wanted);

}  // namespace noctule::ui
