// SPDX-License-Identifier: Apache-2.0
// Icon, name and value, one below the other: the numbers that end a dock ("Boards   17 of 18").
#pragma once

#include <QWidget>
#include <vector>

#include "ui/style/ink.h"

class QVBoxLayout;

namespace noctule::ui {

class BarMeter;
class IconLabel;
class Label;

class NumberRows : public QWidget {
    Q_OBJECT
public:
    explicit NumberRows(QWidget* parent = nullptr);

    /// Its number.
    int addRow(const QString& icon, const QString& name);
    /// Empty: not known, the row goes. `fraction` 0..1 shows a bar below.
    void setValue(int row, const QString& value, Tone tone = Tone::kNeutral, double fraction = -1);
    /// Below the name; empty: nothing.
    void setHint(int row, const QString& hint);
    QString value(int row) const;

private:
    struct Row {
        QWidget* widget;
        IconLabel* icon;
        QString icon_name;
        Label *name, *value, *hint;
        BarMeter* bar;
        Tone tone = Tone::kNeutral;
    };
    QVBoxLayout* column_;
    std::vector<Row> rows_;
};

}  // namespace noctule::ui
