// SPDX-License-Identifier: Apache-2.0
// One number, large, with what it is below: "2.1°" / "mean joint error against the reference".
#pragma once

#include "ui/style/ink.h"
#include "ui/widgets/card.h"

namespace noctule::ui {

class Label;

class ValueCard : public Card {
    Q_OBJECT
public:
    explicit ValueCard(const QString& value = {}, const QString& caption = {}, QWidget* parent = nullptr);

    void setValue(const QString& value, Tone tone = Tone::kNeutral);
    /// May hold one line break.
    void setCaption(const QString& caption);

private:
    void tellName();

    Label* value_;
    Label* caption_;
};

}  // namespace noctule::ui
