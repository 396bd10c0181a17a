// SPDX-License-Identifier: Apache-2.0
// The sphere of directions from which a magnetometer has seen the Earth's field, from the front and from
// behind: cells fill from few readings to many, and the side that is still empty is named below.
#pragma once

#include <QWidget>

#include "core/sensor_calibration/field_sphere.h"

namespace noctule::ui {

class FieldDrawing : public QWidget {
    Q_OBJECT
public:
    explicit FieldDrawing(QWidget* parent = nullptr);

    /// Of `sphere`, and the side that is called out, if any.
    void show(const FieldSphere& sphere, std::optional<FieldSide> empty);
    using QWidget::show;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Globe {
        QPointF middle;
        double radius = 0;
        bool is_behind = false;
    };
    void paintGlobe(QPainter& painter, const Globe& globe) const;
    void paintCell(QPainter& painter, const Globe& globe, int cell) const;
    void paintArrow(QPainter& painter, const Globe& globe) const;
    void paintScale(QPainter& painter, const QRect& row) const;

    FieldSphere sphere_;
    std::optional<FieldSide> empty_;
};

}  // namespace noctule::ui
