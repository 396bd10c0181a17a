// SPDX-License-Identifier: Apache-2.0
// One fact of a list in a dock: icon in the colour of its state, name, value at the right, below it a hint
// and a bar where they help ("Good pairs   57 of 144").
#pragma once

#include <QWidget>
#include <optional>

#include "ui/style/ink.h"

namespace noctule::ui {

class BarMeter;
class IconLabel;
class Label;

class FactRow : public QWidget {
    Q_OBJECT
public:
    FactRow(const QString& icon_name, const QString& name, QWidget* parent = nullptr);

    struct Fact {
        Tone tone = Tone::kNeutral;
        QString value, hint;
        std::optional<double> share;  ///< 0..1, as a bar
    };
    void setFact(const Fact& fact);
    QString value() const;
    QString hint() const;
    Tone tone() const { return tone_; }

private:
    QString icon_name_, name_text_;
    Tone tone_ = Tone::kNeutral;
    IconLabel* icon_;
    Label* value_;
    Label* hint_;
    BarMeter* bar_;
};

}  // namespace noctule::ui
