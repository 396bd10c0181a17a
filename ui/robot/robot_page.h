// SPDX-License-Identifier: Apache-2.0
// The step "Robot": a suit or a take drives a robot's arms. The dead man's key is F8, held; it counts as
// released when the window loses the keyboard or the page is left.
#pragma once

#include "ui/robot/robot_drive.h"
#include "ui/views/page.h"

class QStackedWidget;

namespace noctule::ui {

class RobotCenter;
class RobotSidebar;
class RobotStatePanel;

class RobotPage : public Page {
    Q_OBJECT
public:
    RobotPage(Studio& studio, RobotDrive& drive, QWidget* parent = nullptr);
    ~RobotPage() override;

    QString title() const override { return tr("Robot"); }
    QWidget* leftDock() override { return left_; }
    QWidget* rightDock() override { return right_; }
    void enter() override;
    void leave() override;

    RobotCenter& center() { return *center_; }
    RobotSidebar& sidebar() { return *sidebar_; }
    RobotStatePanel& state() { return *state_; }

signals:
    /// The suit leads: begin a take, or end the one that is being recorded.
    void suitRecordingWanted();

public slots:
    void chooseRobot();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addActions();
    void showRobot();
    bool actOnKey(QEvent& event);

    RobotDrive& drive_;
    RobotCenter* center_;
    RobotSidebar* sidebar_;
    RobotStatePanel* state_;
    QStackedWidget* stack_;
    QWidget *robot_part_, *empty_, *left_, *right_;
    QList<QAction*> of_robot_;  ///< need one
};

}  // namespace noctule::ui
