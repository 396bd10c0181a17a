// SPDX-License-Identifier: Apache-2.0
// The chosen board in detail: which pulses it hears, how it turns and accelerates, what of its frames
// arrives.
#pragma once

#include "ui/models/capture_context.h"
#include "ui/widgets/card.h"

class QVBoxLayout;

namespace noctule::ui {

class Button;
class Label;
class LiveCurve;
class PulseBars;

class BoardCard : public Card {
    Q_OBJECT
public:
    explicit BoardCard(CaptureContext& capture, QWidget* parent = nullptr);

    int board() const { return board_; }
    /// -1: none is chosen, and the card says what to do.
    void setBoard(int board);

signals:
    void blinkRequested(int board);

private:
    void addCurves(QVBoxLayout& column);
    void showFrame();
    void showWords();

    LiveSuit& live() const { return capture_.suit(); }
    SuitCheck& check() const { return capture_.check(); }

    CaptureContext& capture_;
    int board_ = -1;
    Label *title_, *serial_, *frames_;
    PulseBars* pulses_;
    LiveCurve *turning_, *acceleration_;
    QWidget* details_;
    Button* blink_;
};

}  // namespace noctule::ui
