// SPDX-License-Identifier: Apache-2.0
// The confidence colours between 0 and 1.
#pragma once

#include <QWidget>

namespace noctule::ui {

class ConfidenceLegend : public QWidget {
    Q_OBJECT
public:
    explicit ConfidenceLegend(QWidget* parent = nullptr);
    QSize sizeHint() const override;

    static constexpr int kDecimals = 1;  ///< of its ends and of the axis in the plots

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace noctule::ui
