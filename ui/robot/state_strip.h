// SPDX-License-Identifier: Apache-2.0
// The four states of a robot in their order, the present one lit: word, icon, colour, and what it means.
#pragma once

#include <QWidget>

#include "ui/robot/robot_drive.h"

namespace noctule::ui {

class StateStrip : public QWidget {
    Q_OBJECT
public:
    explicit StateStrip(QWidget* parent = nullptr);

    /// `is_error`: it holds since the robot is gone or does not obey.
    void show(RobotWord word, const QString& reason, double accept_within_rad, bool is_error);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString meaningOf(RobotWord word) const;

    RobotWord word_ = RobotWord::kNotSynchronised;
    QString reason_;
    double accept_within_rad_ = 0;
    bool is_error_ = false;
};

}  // namespace noctule::ui
