// SPDX-License-Identifier: Apache-2.0
// The left dock: the robot and its link, who leads it and how, its speed, when it holds by itself, and what
// it did in this session.
#pragma once

#include <QWidget>

#include "ui/robot/robot_drive.h"

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace noctule::ui {

class Button;
class Label;
class ProblemCard;

class RobotSidebar : public QWidget {
    Q_OBJECT
public:
    explicit RobotSidebar(RobotDrive& drive, QWidget* parent = nullptr);

    QComboBox& leader() { return *leader_; }
    QSlider& speed() { return *speed_; }

signals:
    void changeWanted();

private:
    QWidget* makeRobot();
    QWidget* makeLeading();
    QWidget* makeSpeed();
    QWidget* makeLimits();
    void connectFields();
    void showRobot();
    void showLink();
    void showLeader();
    void showSpells();
    void choose();

    RobotDrive& drive_;
    Label *name_, *answers_, *about_, *lengths_, *speed_text_, *fastest_;
    ProblemCard* problem_ = nullptr;
    QBoxLayout* robot_column_;
    Button *connect_, *change_, *remove_;
    QComboBox *leader_, *body_, *follows_;
    QSlider* speed_;
    QDoubleSpinBox* within_;
    Label* spells_;
};

}  // namespace noctule::ui
