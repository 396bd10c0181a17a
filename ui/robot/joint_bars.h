// SPDX-License-Identifier: Apache-2.0
// Each driven joint: name, achieved and commanded value, and both on a bar between its limits, whose last
// five percent are tinted. Commanded is dashed, achieved filled.
#pragma once

#include <QWidget>

#include "ui/robot/robot_drive.h"

namespace noctule::ui {

class JointBars : public QWidget {
    Q_OBJECT
public:
    explicit JointBars(QWidget* parent = nullptr);

    void setParts(std::shared_ptr<const RobotParts> parts);
    /// `wanted`: commanded, or what the performer asks for while nothing is followed.
    void show(const std::vector<double>& achieved, const std::vector<double>& wanted);
    /// In the last 5 % before a limit.
    bool isAtLimit(size_t joint) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int rowHeight() const;
    void paintRow(QPainter& painter, size_t joint, const QRect& row) const;
    void paintBar(QPainter& painter, size_t joint, const QRect& bar) const;

    std::shared_ptr<const RobotParts> parts_;
    std::vector<double> achieved_, wanted_;
};

}  // namespace noctule::ui
