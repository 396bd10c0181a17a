// SPDX-License-Identifier: Apache-2.0
// The right dock: what the robot does, in words; each joint; what is to be looked at; and the way on.
#pragma once

#include <QWidget>

#include "ui/robot/robot_drive.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class JointBars;
class Label;
class ProblemCard;
class VerdictHeader;

class RobotStatePanel : public QWidget {
    Q_OBJECT
public:
    explicit RobotStatePanel(RobotDrive& drive, QWidget* parent = nullptr);

    JointBars& joints() { return *joints_; }
    /// The way on: connect, follow, synchronise again, reset.
    Button& wayOn() { return *way_on_; }
    /// Verdict and the sentence below it, for tests.
    QString verdict() const { return verdict_text_; }

private:
    void showState();
    void showJoints();
    void showProblem();
    void showWayOn();
    void goOn();

    RobotDrive& drive_;
    VerdictHeader* verdict_;
    QString verdict_text_;
    QWidget* joints_head_;  ///< there while joints are listed
    JointBars* joints_;
    QBoxLayout* problems_;
    ProblemCard* problem_ = nullptr;
    bool problem_is_error_ = false;
    Button* way_on_;
    Label* way_about_;
};

}  // namespace noctule::ui
