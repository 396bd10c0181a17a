// SPDX-License-Identifier: Apache-2.0
// One calibration on the overview: what it finds out, what it takes, when and how well it was made last, and
// the way into its wizard.
#pragma once

#include "ui/style/ink.h"
#include "ui/widgets/card.h"
#include "ui/wizards/wizard_task.h"

namespace noctule::ui {

class Button;
class IconLabel;
class Label;

class TaskCard : public Card {
    Q_OBJECT
public:
    explicit TaskCard(const WizardWords& words, QWidget* parent = nullptr);

    /// "17 of 18 boards, 3 days ago, good"
    void setState(Tone tone, const QString& state);
    QString state() const;
    void setButton(const QString& text, bool is_next);
    Button* button() { return button_; }

private:
    Label* state_;
    IconLabel* state_icon_;
    Button* button_;
};

}  // namespace noctule::ui
