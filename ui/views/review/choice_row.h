// SPDX-License-Identifier: Apache-2.0
// A check box or radio button with a line below it that says what choosing it means; where it cannot be
// chosen the line says why.
#pragma once

#include <QWidget>

class QAbstractButton;

namespace noctule::ui {

class Label;

class ChoiceRow : public QWidget {
    Q_OBJECT
public:
    enum class Kind { kCheck, kRadio };
    ChoiceRow(Kind kind, const QString& name, const QString& meaning, QWidget* parent = nullptr);

    QAbstractButton* button() { return button_; }
    bool isChecked() const;
    void setChecked(bool checked);
    /// The reason stands in place of the meaning; empty: it can be chosen.
    void setDisabledBecause(const QString& reason);

private:
    QAbstractButton* button_;
    Label* meaning_label_;
    QString meaning_;
};

}  // namespace noctule::ui
