// SPDX-License-Identifier: Apache-2.0
// Where a room bends the Earth's field: its strength where the suit is carried, and near the floor, as marks
// on a scale with the limit, beside a drawing of the two heights.
#pragma once

#include <QWidget>

#include "core/sensor_calibration/field_turn.h"

namespace noctule::ui {

class FieldHeights : public QWidget {
    Q_OBJECT
public:
    explicit FieldHeights(QWidget* parent = nullptr);

    /// `is_at_floor`: the suit is on its way to the floor. `now_percent`: how much stronger the field is at
    /// the moment.
    void show(const SpotField& spot, bool is_at_floor, std::optional<double> now_percent);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Scale {
        double left, right;
        double at(double percent) const;
    };
    void paintRoom(QPainter& painter, const QRectF& area) const;
    void paintScale(QPainter& painter, const Scale& scale, double top, double bottom) const;
    void paintMark(QPainter& painter, const Scale& scale, double y, bool of_floor) const;
    QString wordsOf(bool of_floor) const;
    double heightOf(bool of_floor) const;

    SpotField spot_;
    bool is_at_floor_ = false;
    std::optional<double> now_percent_;
};

}  // namespace noctule::ui
