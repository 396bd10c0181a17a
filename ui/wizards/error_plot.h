// SPDX-License-Identifier: Apache-2.0
// The picture of a calibration's errors: a row per part, a dot per measurement, before and after, with the
// band of what is good. What lies beyond the scale is a triangle at its end.
#pragma once

#include <QWidget>

#include "core/report/calibration_document.h"

namespace noctule::ui {

class ErrorPlot : public QWidget {
    Q_OBJECT
public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    void setErrors(const CalibrationErrors& errors);
    /// Of the errors of both calibrations; the caption says how they are marked.
    bool hasBeyondScale() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// From zero at `left` to `end` at `right`; pixels.
    struct Axis {
        int left, right, bottom;
        double end;
        double at(double value) const { return left + (right - left) * value / end; }
    };
    Axis axis() const;
    void paintAxis(QPainter& painter, const Axis& axis) const;
    void paintDots(QPainter& painter, const Axis& axis, const std::vector<double>& values, double y,
                   const QColor& color) const;
    double scaleEnd() const;

    CalibrationErrors errors_;
};

}  // namespace noctule::ui
