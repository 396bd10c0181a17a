// SPDX-License-Identifier: Apache-2.0
// A board (rounded square) or a source (circle) on the body map, with its number; a button of 28 px.
#pragma once

#include <QAbstractButton>

#include "ui/style/ink.h"

namespace noctule::ui {

class MapMarker : public QAbstractButton {
    Q_OBJECT
public:
    enum class Shape { kBoard, kSource };

    MapMarker(Shape shape, int number, const QString& name, QWidget* parent);

    void setTone(Tone tone);
    Tone tone() const { return tone_; }
    /// Filled: this one is talked about.
    void setChosen(bool chosen);
    Shape shape() const { return shape_; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    Shape shape_;
    Tone tone_ = Tone::kNeutral;
    bool chosen_ = false;
};

}  // namespace noctule::ui
