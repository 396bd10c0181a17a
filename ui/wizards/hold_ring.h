// SPDX-License-Identifier: Apache-2.0
// The ring that fills while a step is right, "2 / 4 s", or with a share of a whole, "71 %".
#pragma once

#include <QWidget>

#include "ui/style/ink.h"

namespace noctule::ui {

class HoldRing : public QWidget {
    Q_OBJECT
public:
    explicit HoldRing(QWidget* parent = nullptr);

    void show(double share, double hold_s, Tone tone);
    void showShare(double share, Tone tone);
    using QWidget::show;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double share_ = 0, hold_s_ = 1;  ///< 0: a share is shown
    Tone tone_ = Tone::kNeutral;
};

}  // namespace noctule::ui
