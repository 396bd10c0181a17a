// SPDX-License-Identifier: Apache-2.0
// The picture of a calibration's errors: a row per part, a dot per measurement, before and after, with the
// band of what is good. Outliers beyond the scale stand at its end and are named.
#pragma once

#include <QWidget>

#include "core/report/calibration_document.h"

namespace noctule::ui {

class ErrorPlot : public QWidget {
    Q_OBJECT
public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    void setErrors(const CalibrationErrors& errors);
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
                   const QColor& color, bool marks_beyond) const;
    double scaleEnd() const;

    CalibrationErrors errors_;
};

}  // namespace noctule::ui
