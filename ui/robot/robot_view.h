// SPDX-License-Identifier: Apache-2.0
// The robot in 3D: filled where it is, as an outline where it is told to be (before it follows: where the
// performer would have it), and the last seconds of its hand's way.
#pragma once

#include <QWidget>

#include "core/render/scene.h"
#include "ui/robot/robot_drive.h"

namespace noctule::ui {

class CameraControl;
class EmptyState;
class Label;
class SceneCanvas;

class RobotView : public QWidget {
    Q_OBJECT
public:
    explicit RobotView(RobotDrive& drive, QWidget* parent = nullptr);
    ~RobotView() override;

    void setArm(size_t arm) { arm_ = arm; }
    /// What is drawn, for tests: bodies are the robot, then its outline.
    const Scene& compose();

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void takeRobot();
    void frame();
    void addHand(const robot::RobotArm& arm, const robot::JointValues& now);
    robot::JointValues valuesOf(const std::vector<double>& q) const;

    RobotDrive& drive_;
    size_t arm_ = 0;
    CameraControl* control_;
    SceneCanvas* canvas_ = nullptr;
    EmptyState* message_;
    Label *title_, *legend_;
    std::shared_ptr<const RobotParts> parts_;
    std::shared_ptr<const SkinnedMesh> mesh_;
    double lift_m_ = 0;
    Eigen::AlignedBox3d box_;
    bool is_framed_ = false;
    Scene scene_;
};

}  // namespace noctule::ui
