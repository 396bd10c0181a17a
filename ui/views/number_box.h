// SPDX-License-Identifier: Apache-2.0
// A spin box that writes numbers as the rest of the studio does, with a real minus (U+2212), and reads both
// that one and the key of the keyboard.
#pragma once

#include <QDoubleSpinBox>

namespace noctule::ui {

class NumberBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& cursor) const override;
};

}  // namespace noctule::ui
