// SPDX-License-Identifier: Apache-2.0
// The card of one of several suits (suit_cards.h), with the stripe of its performer.
#pragma once

#include "ui/views/suit_cards.h"
#include "ui/widgets/card.h"

class QLabel;

namespace noctule::ui {

class Button;
class Chip;
class ElidedLabel;
class Label;

class SuitStateCard : public Card {
    Q_OBJECT
public:
    explicit SuitStateCard(QWidget* parent = nullptr);

    void setWords(const SuitStateWords& words);
    Button* showButton() const { return show_; }

signals:
    void showWanted();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void decorate();

    SuitStateWords words_;
    QLabel* disc_;
    ElidedLabel *name_, *box_;
    Chip* verdict_;
    Label* problem_;
    Button* show_;
};

}  // namespace noctule::ui
