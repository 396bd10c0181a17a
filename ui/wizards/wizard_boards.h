// SPDX-License-Identifier: Apache-2.0
// Right of a wizard while it runs: the boards and what they have, and the ways to put something right: repeat
// a step, leave a board out, one step back.
#pragma once

#include <QWidget>

namespace noctule::ui {

class BoardTable;
class Button;
class Label;
class WizardRun;

class WizardBoards : public QWidget {
    Q_OBJECT
public:
    explicit WizardBoards(QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    /// Chosen in the rail, to be repeated; -1: the last one.
    void setStep(int step);
    BoardTable& table() { return *table_; }
    Button* skipButton() { return skip_; }
    Button* repeatButton() { return repeat_; }
    /// Calibrates with what there is.
    Button* enoughButton() { return enough_; }

    void skipBoard();
    void repeatStep();

private:
    void refresh();
    int boardToSkip() const;

    WizardRun* run_ = nullptr;
    Label *count_, *words_;
    BoardTable* table_;
    Button *repeat_, *skip_, *back_, *enough_;
    int step_ = -1;
};

}  // namespace noctule::ui
