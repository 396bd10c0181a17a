// SPDX-License-Identifier: Apache-2.0
#include "ui/views/window_place.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <QWindow>
#include <algorithm>

namespace noctule::ui {

namespace {
/// A window has no frame before it is shown; title bars of desktops are 24 to 38 px high, side frames 0 to 5.
constexpr int kTitleBar = 38, kAboveDialog = 40;
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

QSize roomOf(const QWidget& dialog) {
    const QWidget* first = &dialog;  // a dialog may belong to another one
    while (first->parentWidget())
        first = first->parentWidget()->window();
    QSize room = freeRoom(dialog).size();
    if (first != &dialog && first->isVisible())
        room = room.boundedTo(first->size());
    return room - QSize(0, kAboveDialog);
}

void placeDialog(QWidget& dialog, const QSize& wanted) {
    const QRect place =
        placeWithin({dialog.pos(), wanted.boundedTo(roomOf(dialog))}, freeRoom(dialog)).content;
    dialog.resize(place.size());
    if (const QWindow* shown = dialog.windowHandle(); shown && shown->isVisible())
        dialog.move(place.topLeft());
}

}  // namespace noctule::ui
