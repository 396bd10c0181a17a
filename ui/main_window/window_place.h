// SPDX-License-Identifier: Apache-2.0
// Where a window may stand: never larger than what the desktop leaves free, frame and title bar included.
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

}  // namespace noctule::ui
