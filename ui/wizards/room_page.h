// SPDX-License-Identifier: Apache-2.0
// The survey of a room: where its anchors hang, from the take that is open. Plan and front view, what is
// wrong and what to do, every anchor at the right, and the places put in force.
#pragma once

#include <QWidget>

#include "ui/wizards/room_run.h"
#include "ui/wizards/wizard_task.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class EmptyState;
class JobProgress;
class Label;
class MeasureMeter;
class RoomDrawing;

/// Of its card on the overview.
WizardWords roomWords();

class RoomPage : public QWidget {
    Q_OBJECT
public:
    explicit RoomPage(Studio& studio, QWidget* parent = nullptr);

    /// What stands at its right.
    QWidget* side() { return side_; }
    RoomRun& run() { return *run_; }
    Button* surveyButton() { return survey_; }
    Button* useButton() { return use_; }
    Button* processButton() { return process_; }
    Button* saveButton() { return save_; }
    /// Surveys the open take unless that has been done.
    void enter();

signals:
    void leaveRequested();

private:
    QWidget* makeCentre();
    QWidget* makeSide();
    void refresh();
    void showResult();
    void showAnchors();
    void showFindings();
    void chooseFile();
    void process();

    Studio& studio_;
    RoomRun* run_;
    Label *lead_, *headline_, *note_;
    EmptyState* empty_;
    QWidget *found_, *side_ = nullptr;
    RoomDrawing *plan_, *front_;
    JobProgress* progress_;
    QBoxLayout *findings_ = nullptr, *anchors_ = nullptr;
    MeasureMeter *heard_, *error_, *agreement_;
    Label* words_;
    Button *survey_, *use_, *process_, *save_, *leave_;
};

}  // namespace noctule::ui
