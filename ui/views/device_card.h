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

struct DeviceWords {
    QString icon;
    int colour = -1;  ///< of the suit; -1: none
    QString name;
    QString state;  ///< "connected"; empty: none
    Tone tone = Tone::kNeutral;
    QString detail;
    QString action;  ///< empty: none
    bool chosen = false;
    bool operator==(const DeviceWords&) const = default;
};

class DeviceCard : public Card {
    Q_OBJECT
public:
    explicit DeviceCard(QWidget* parent = nullptr);

    void setWords(const DeviceWords& words);
    const DeviceWords& words() const { return words_; }
    Button* button() const { return button_; }

signals:
    void activated();

private:
    DeviceWords words_;
    IconLabel *icon_, *state_icon_;
    ElidedLabel* name_;
    Label *state_, *detail_;
    QHBoxLayout *head_, *foot_;
    Button* button_;
};

}  // namespace noctule::ui
