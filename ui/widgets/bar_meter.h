// SPDX-License-Identifier: Apache-2.0
// Thin bar, 4 px, for a share of a whole ("96 %" of a joint's ranges), in the colour of its tone. For table
// cells, paint() draws the same without a widget.
#pragma once

#include <QWidget>

#include "ui/style/ink.h"

namespace noctule::ui {

class BarMeter : public QWidget {
    Q_OBJECT
public:
    explicit BarMeter(QWidget* parent = nullptr);

    /// `fraction` 0..1; `words` are what screen readers hear ("71 percent of ranges").
    void setValue(double fraction, Tone tone = Tone::kAccent, const QString& words = {});
    double fraction() const { return fraction_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// Centred vertically in `area`.
    static void paint(QPainter& painter, const QRect& area, double fraction, const QColor& color);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double fraction_ = 0;
    Tone tone_ = Tone::kAccent;
};

}  // namespace noctule::ui
