// SPDX-License-Identifier: Apache-2.0
// A card with an edge in the colour of its tone.
#pragma once

#include "ui/style/ink.h"
#include "ui/widgets/card.h"

namespace noctule::ui {

class ToneCard : public Card {
    Q_OBJECT
public:
    using Card::Card;

    void setTone(Tone tone);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Tone tone_ = Tone::kNeutral;
};

}  // namespace noctule::ui
