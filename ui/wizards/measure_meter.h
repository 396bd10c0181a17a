// SPDX-License-Identifier: Apache-2.0
// One measure of a running wizard: a mark, its name, its value and a bar, in the colour of right or not yet.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/wizards/wizard_words.h"

class QGridLayout;

namespace noctule::ui {

class BarMeter;
class IconLabel;
class Label;

class MeasureMeter : public QWidget {
    Q_OBJECT
public:
    enum class Form {
        kBeside,  ///< the value at the end of the name's line, the bar below
        kBelow,   ///< the value below the name: it needs more room than a small window has
        kLine,    ///< all in one line, for meters that stand on one another
    };
    explicit MeasureMeter(Form form);

    void setForm(Form form);
    void setMeasure(const LiveMeasure& measure);
    /// Pixels that name and value need in one line.
    int widthBeside() const;

private:
    IconLabel* icon_;
    Label *name_, *value_;
    BarMeter* bar_;
    QGridLayout* grid_;
    std::optional<Form> form_;
};

}  // namespace noctule::ui
