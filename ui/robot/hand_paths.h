// SPDX-License-Identifier: Apache-2.0
// The hand of the robot in three views, commanded against achieved (Miller 2004, figure 9), for the last
// seconds. Axes of the chest: X to the left, Y up, Z ahead; one division is 100 mm.
#pragma once

#include <QWidget>

#include "ui/robot/robot_drive.h"

namespace noctule::ui {

class HandPathsView : public QWidget {
    Q_OBJECT
public:
    explicit HandPathsView(QWidget* parent = nullptr);

    void show(RobotDrive::HandPaths paths);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct View;
    void paintView(QPainter& painter, const View& view, const QRect& frame) const;

    RobotDrive::HandPaths paths_;
};

}  // namespace noctule::ui
