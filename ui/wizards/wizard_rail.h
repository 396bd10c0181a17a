// SPDX-License-Identifier: Apache-2.0
// Left of a wizard: its steps with their state, what holds for all of them, tones, and the way out that keeps
// what has been taken. A step that is done can be chosen, to be repeated.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <vector>

#include "ui/wizards/wizard_run.h"

class QCheckBox;
class QVBoxLayout;

namespace noctule::ui {

class Button;
class Label;

class RailStep : public QAbstractButton {
    Q_OBJECT
public:
    enum class State { kWaiting, kCurrent, kDone };

    explicit RailStep(QWidget* parent = nullptr);
    void setStep(State state, const QString& name, const QString& hint, bool chosen);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    State state_ = State::kWaiting;
    QString name_, hint_;
    bool chosen_ = false;
};

class WizardRail : public QWidget {
    Q_OBJECT
public:
    explicit WizardRail(QWidget* parent = nullptr);

    /// Null: nothing runs.
    void setRun(WizardRun* run);
    void setWayBack(const QString& words) { way_back_ = words; }
    /// A step that is done and has been chosen; -1: none.
    int chosenStep() const { return chosen_; }
    Button* leaveButton() { return leave_; }

signals:
    void leaveRequested();
    void stepChosen(int step);

private:
    void refresh();
    RailStep* row(size_t index);

    WizardRun* run_ = nullptr;
    QString way_back_;
    Label *title_, *hint_;
    QVBoxLayout* rows_column_;
    std::vector<RailStep*> rows_;
    QCheckBox* tones_;
    Button* leave_;
    int chosen_ = -1;
};

}  // namespace noctule::ui
