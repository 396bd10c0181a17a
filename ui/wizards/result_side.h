// SPDX-License-Identifier: Apache-2.0
// Right of a wizard's result: what was found wrong and what to repeat, then saving, with what it will be
// called and that it can be undone.
#pragma once

#include <QWidget>

namespace noctule::ui {

class Button;
class FindingList;
class Label;
class Studio;
class WizardRun;

class ResultSide : public QWidget {
    Q_OBJECT
public:
    explicit ResultSide(Studio& studio, QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    void setWayBack(const QString& words);
    Button* saveButton() { return save_; }
    Button* repeatButton() { return repeat_; }

signals:
    /// Back to the steps.
    void repeatRequested();
    void leaveRequested();

private:
    void refresh();
    void save();

    Studio& studio_;
    WizardRun* run_ = nullptr;
    FindingList* findings_;
    Label* words_;
    Button *save_, *process_, *repeat_, *leave_;
};

}  // namespace noctule::ui
