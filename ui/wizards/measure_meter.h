// SPDX-License-Identifier: Apache-2.0
// One measure of a running wizard: a mark, its name, its value and a bar, in the colour of right or not yet.
#pragma once

#include <QWidget>

#include "ui/wizards/wizard_words.h"

namespace noctule::ui {

class BarMeter;
class IconLabel;
class Label;

class MeasureMeter : public QWidget {
    Q_OBJECT
public:
    enum class Value {
        kBeside,  ///< the name, in one line
        kBelow,   ///< it, for values that need more room than a small window has
    };
    explicit MeasureMeter(Value value);

    void setMeasure(const LiveMeasure& measure);

private:
    IconLabel* icon_;
    Label *name_, *value_;
    BarMeter* bar_;
};

}  // namespace noctule::ui
