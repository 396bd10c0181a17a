// SPDX-License-Identifier: Apache-2.0
// Label at the left, control at the right, all labels in one column of a fixed width as on the Export dialog;
// hints stand below their control, values ("Drift of heading   under 0.9° per minute") are right-aligned.
#pragma once

#include <QWidget>
#include <vector>

class QGridLayout;

namespace noctule::ui {

class Label;

class FormRows : public QWidget {
    Q_OBJECT
public:
    /// `label_width` at 100 percent; 0: as wide as the widest label.
    explicit FormRows(int label_width = 0, QWidget* parent = nullptr);

    /// Label and control in one row; the label is the control's buddy and accessible name.
    Label* addRow(const QString& label, QWidget* control);
    /// In the column of the controls, without a label.
    void addControl(QWidget* control);
    Label* addHint(const QString& text);
    /// Label and words, dense (22 px). Returns the value's label.
    Label* addValue(const QString& label, const QString& value);

    /// Forms below each other: the widest label of all decides where their controls stand.
    static void alignLabels(const std::vector<FormRows*>& forms);

private:
    int nextRow() const;
    int widestLabel() const;
    void addInSecondColumn(QWidget* widget);

    int label_width_;
    QGridLayout* grid_;
};

}  // namespace noctule::ui
