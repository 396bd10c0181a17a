// SPDX-License-Identifier: Apache-2.0
// Ring around the widget that has the keyboard: 2 px of accent, 2 px off, drawn over the window so that no
// control has to leave room for it. It shows when focus came by the keyboard, or when keys are pressed
// afterwards; a mouse click needs no ring. Widgets that mark the place themselves (a heat map its cell)
// switch it off with setOwnFocusMark().
#pragma once

#include <QPointer>
#include <QWidget>

namespace noctule::ui {

class Theme;

/// `widget` draws by itself where the keyboard is.
void setOwnFocusMark(QWidget& widget);

class FocusRing : public QObject {
    Q_OBJECT
public:
    FocusRing(Theme& theme, QApplication& application);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    class Overlay;
    void follow(QWidget* widget);
    void place();
    void hide();

    QPointer<QWidget> target_;
    QPointer<Overlay> overlay_;
    bool by_keyboard_ = false;
};

}  // namespace noctule::ui
