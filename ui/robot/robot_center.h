// SPDX-License-Identifier: Apache-2.0
// The middle of the page: the four states, who leads and the robot side by side, the operator's keys, the
// hand's way in three views with delay and residual, and what can be done with a recorded motion.
#pragma once

#include <QWidget>

#include "ui/robot/robot_drive.h"

class QGridLayout;
class QStackedWidget;

namespace noctule::ui {

class Button;
class HandPathsView;
class KeyCard;
class Label;
class RobotView;
class SceneView;
class StateStrip;

class RobotCenter : public QWidget {
    Q_OBJECT
public:
    RobotCenter(Studio& studio, RobotDrive& drive, QWidget* parent = nullptr);

    KeyCard& deadMan() { return *dead_man_; }
    KeyCard& clutch() { return *clutch_; }
    KeyCard& stopKey() { return *stop_; }
    RobotView& robot() { return *robot_; }
    /// "delay" and so on, as they stand on the screen; for tests.
    QString figure(int row) const;
    Button& record() { return *record_; }
    Button& showsRecorded() { return *recorded_; }

signals:
    /// The suit leads: begin a take, or end the one that is being recorded.
    void suitRecordingWanted();

public slots:
    void play();
    void exportCommands();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeViews();
    QWidget* makeKeys();
    QWidget* makePaths();
    QWidget* makeFoot();
    void arrangeKeys();
    void showKeys();
    void showState();
    void showLeader();
    void showPaths();
    void showFigures(const RobotDrive::HandPaths& paths);
    void showRecording();
    void toggleRecording();
    void wear();
    void showFrame();

    Studio& studio_;
    RobotDrive& drive_;
    StateStrip* strip_;
    QStackedWidget* leaders_;
    SceneView *live_, *take_;
    RobotView* robot_;
    QGridLayout* keys_ = nullptr;
    KeyCard *dead_man_, *clutch_, *hold_, *stop_;
    HandPathsView* paths_;
    Label* figures_[4];
    Button *record_, *play_, *repeats_, *export_, *recorded_;
    int key_columns_ = 0;
    QElapsedTimer since_paths_;
};

}  // namespace noctule::ui
