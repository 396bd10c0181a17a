// SPDX-License-Identifier: Apache-2.0
// One device in the list: what it is, how it fares, and the one thing that can be done with it.
#pragma once

#include "ui/style/ink.h"
#include "ui/widgets/card.h"

class QHBoxLayout;

namespace noctule::ui {

class Button;
class ElidedLabel;
class IconLabel;
class Label;
class ToolButton;

struct DeviceWords {
    QString icon;
    int colour = -1;  ///< of the suit; -1: none
    QString name;
    QString state;  ///< "connected"; empty: none
    Tone tone = Tone::kNeutral;
    QString detail;
    QString action;  ///< empty: none
    QString serial;  ///< empty: it cannot be named
    bool chosen = false;
    bool can_be_forgotten = false;  ///< in the menu, where no click meant for the button can meet it
    bool operator==(const DeviceWords&) const = default;
};

class DeviceCard : public Card {
    Q_OBJECT
public:
    explicit DeviceCard(QWidget* parent = nullptr);

    void setWords(const DeviceWords& words);
    const DeviceWords& words() const { return words_; }
    Button* button() const { return button_; }
    ToolButton* renameButton() const { return rename_; }
    ToolButton* menuButton() const { return more_; }

signals:
    void activated();
    void named(const QString& serial, const QString& name);
    void forgotten(const QString& serial);

private:
    void askForName();

    DeviceWords words_;
    IconLabel *icon_, *state_icon_;
    ElidedLabel* name_;
    Label *state_, *detail_;
    QHBoxLayout *head_, *foot_;
    Button* button_;
    ToolButton *rename_, *more_;
};

}  // namespace noctule::ui
