// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/window_place.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <QWindow>
#include <algorithm>

namespace noctule::ui {

namespace {
/// A window has no frame before it is shown; title bars of desktops are 24 to 38 px high, side frames 0 to 5.
constexpr int kTitleBar = 38;
}  // namespace

WindowPlace placeWithin(const QRect& wanted, const QRect& available) {
    const QRect room = available.adjusted(0, kTitleBar, 0, 0);
    WindowPlace place{wanted, wanted.width() > room.width() || wanted.height() > room.height()};
    place.content.setSize(wanted.size().boundedTo(room.size()));
    const int right = room.right() - place.content.width() + 1,
              bottom = room.bottom() - place.content.height() + 1;
    place.content.moveTo(std::clamp(wanted.left(), room.left(), right),
                         std::clamp(wanted.top(), room.top(), bottom));
    return place;
}

QRect freeRoom(const QWidget& window) {
    const QScreen* screen = window.windowHandle() ? window.windowHandle()->screen() : nullptr;
    if (!screen)
        screen = QGuiApplication::screenAt(window.geometry().center());
    if (!screen)
        screen = QGuiApplication::primaryScreen();
    return screen->availableGeometry();
}

}  // namespace noctule::ui
