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
    double scaleEnd() const;

    CalibrationErrors errors_;
};

}  // namespace noctule::ui
