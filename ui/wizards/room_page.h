// SPDX-License-Identifier: Apache-2.0
// The survey of a room: where its anchors hang, from the take that is open, or while somebody walks past
// them. Plan and front view, what is wrong and what to do, every anchor at the right, and the places put in
// force.
#pragma once

#include <QWidget>
#include <tuple>

#include "ui/wizards/room_cards.h"
#include "ui/wizards/room_run.h"
#include "ui/wizards/room_walk.h"
#include "ui/wizards/wizard_task.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class EmptyState;
class HoldRing;
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
    RoomWalk& walk() { return *walk_; }
    /// Begins a walk, and ends it.
    Button* walkButton() { return walk_button_; }
    Button* surveyButton() { return survey_; }
    Button* useButton() { return use_; }
    Button* processButton() { return process_; }
    Button* saveButton() { return save_; }
    /// Surveys the open take unless that has been done.
    void enter();
    /// A walk ends in good order, and its take stays.
    void leave();

signals:
    void leaveRequested();

private:
    QWidget* makeCentre();
    QWidget* makeWalk();
    QWidget* makeSide();
    void connectParts();
    void refresh();
    void refreshButtons();
    void refreshReadiness();
    void refreshPictures();
    void showWalk();
    void showTime();
    void showRun();
    void showResult();
    void showWalkTrouble();
    void showSurvey(const SurveyedTake& found, SurveyStage stage);
    int letterOf(const std::string& performer) const;
    QString walkWords() const;
    void pressWalk();
    void openWalked(const QString& take);
    void followRun();
    void chooseFile();
    void process();

    Studio& studio_;
    RoomRun* run_;
    RoomWalk* walk_;
    bool follows_walk_ = false;  ///< its take is opened when it has ended
    bool opens_walked_ = false;
    QString walked_;  ///< take of the last walk
    /// Why a walk cannot begin, and what makes its result worse, as shown last.
    std::tuple<RoomWalk::Phase, QString, QString> readiness_;
    Label *lead_, *headline_, *note_;
    EmptyState* empty_;
    QWidget *found_, *walk_row_ = nullptr, *side_ = nullptr;
    HoldRing* ring_;
    Label* walk_words_;
    RoomDrawing *plan_, *front_;
    QWidget* pictures_ = nullptr;  ///< around both
    JobProgress* progress_;
    QBoxLayout *walk_trouble_ = nullptr, *findings_ = nullptr, *anchors_ = nullptr;
    MeasureMeter *heard_, *error_, *agreement_;
    Label *words_, *why_no_walk_;
    Button *walk_button_, *survey_, *use_, *process_, *save_, *leave_;
};

}  // namespace noctule::ui
